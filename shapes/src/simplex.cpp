// SPDX-License-Identifier: BSD-3-Clause
#include "simplex.h"

#include "nearest.h"

#include <brink/shape.h>

#include <algorithm>

namespace brink {

namespace {

using Corner = Simplex::Corner;
using Needed = Simplex::Needed;

Needed single(int a) { return {1, {a}, {1}}; }

/// The point of the edge between a and b at t of the way.
Needed edge(int a, int b, double t) { return {2, {a, b}, {1 - t, t}}; }

Needed nearest(const Corner* c, int a, int b)
{
    const V3 e = c[b].w - c[a].w;
    const double past_a = -dot(c[a].w, e), before_b = dot(c[b].w, e);
    if (!(past_a > 0)) return single(a);
    if (!(before_b > 0)) return single(b);
    return edge(a, b, past_a / (past_a + before_b));
}

/// Ericson, Real-Time Collision Detection, 2005: the nearest point of a triangle by Voronoi regions.
Needed nearest(const Corner* corners, int i, int j, int k)
{
    const V3 a = corners[i].w, b = corners[j].w, c = corners[k].w;
    const V3 ab = b - a, ac = c - a;
    const double ab_a = -dot(ab, a), ac_a = -dot(ac, a);
    if (ab_a <= 0 && ac_a <= 0) return single(i);
    const double ab_b = -dot(ab, b), ac_b = -dot(ac, b);
    if (ab_b >= 0 && ac_b <= ab_b) return single(j);
    const double ab_c = -dot(ab, c), ac_c = -dot(ac, c);
    if (ac_c >= 0 && ab_c <= ac_c) return single(k);

    // In cross products: those of the dot products would lose twice the digits that a sliver does.
    const V3 n = cross(ab, ac);
    const double area_c = dot(n, cross(a, b));
    if (area_c <= 0 && ab_a > 0 && ab_b < 0) return edge(i, j, ab_a / (ab_a - ab_b));
    const double area_b = dot(n, cross(c, a));
    if (area_b <= 0 && ac_a > 0 && ac_c < 0) return edge(i, k, ac_a / (ac_a - ac_c));
    const double area_a = dot(n, cross(b, c));
    const double from_b = ac_b - ab_b, from_c = ab_c - ac_c;
    if (area_a <= 0 && from_b > 0 && from_c > 0) return edge(j, k, from_b / (from_b + from_c));

    const double sum = area_a + area_b + area_c;
    if (!(area_a > 0 && area_b > 0 && area_c > 0)) return single(i);
    return {3, {i, j, k}, {area_a / sum, area_b / sum, area_c / sum}};
}

double square_at(const Corner* c, const Needed& n)
{
    V3 p = n.weight[0] * c[n.corner[0]].w;
    for (int k = 1; k < n.count; ++k)
        p = p + n.weight[k] * c[n.corner[k]].w;
    return norm_squared(p);
}

/// The face opposite to the newest corner, the last, was the simplex before it: the origin lies on the
/// newest's side of that. Of the other three, those that keep the origin apart, or simply all.
Needed nearest_of_four(const Corner* c, bool all)
{
    const V3 top = c[3].w, a = c[0].w - top, b = c[1].w - top, d = c[2].w - top;
    const V3 ab = cross(a, b), bd = cross(b, d), da = cross(d, a);
    const double volume = dot(ab, d);
    Needed best;
    double least = infinity;
    const auto attempt = [&](V3 normal, int i, int j) {
        if (!all && !(dot(normal, top) * volume >= 0)) return;
        const Needed n = nearest(c, i, j, 3);
        const double square = square_at(c, n);
        if (best.count == 0 || square < least) best = n, least = square;
    };
    attempt(ab, 0, 1);
    attempt(bd, 1, 2);
    attempt(da, 0, 2);
    return best.count == 0 ? Needed{4, {0, 1, 2, 3}, {}} : best;
}

/// Where the origin comes nearest to the edges and faces of the newest of two to four corners, and which of
/// the others that needs.
class NearNewest {
public:
    NearNewest(const Corner* c, int newest) : c_(c), newest_(c[newest].w)
    {
        bool past = false;
        for (int k = 0; k < newest; ++k) {
            way_[k] = c[k].w - newest_;
            past_[k] = -dot(way_[k], newest_);
            past = past || past_[k] > 0;
        }
        if (!past) {
            keep(newest_, 0);
        } else if (newest == 1) {
            edge(0);
        } else if (newest == 2) {
            face(0, 1, cross(way_[0], way_[1]));
        } else {
            faces();
        }
    }

    bool plain = true;
    V3 v;
    double square = infinity;
    int count = 0; // of the others
    int first = 0, second = 0;

private:
    void keep(V3 nearest, int others, int i = 0, int j = 0)
    {
        const double s = norm_squared(nearest);
        if (!(s < square)) return;
        v = nearest, square = s, count = others, first = i, second = j;
    }
    void edge(int k)
    {
        const V3 e = way_[k];
        if (!(dot(c_[k].w, e) > 0)) {
            plain = false;
            return;
        }
        const double inverse = 1 / norm_squared(e);
        const V3 foot = newest_ + (past_[k] * inverse) * e;
        // Once more: what rounding left along the edge would tilt a short vector.
        keep(foot - (dot(foot, e) * inverse) * e, 1, k);
    }
    /// As nearest() of three, but for the edge and the corners that the newest one is not of.
    void face(int i, int j, V3 n)
    {
        const V3 m = cross(n, newest_);
        const double area_j = dot(m, way_[i]), area_i = -dot(m, way_[j]);
        if (area_j <= 0 && past_[i] > 0) return edge(i);
        if (area_i <= 0 && past_[j] > 0) return edge(j);
        const double all = norm_squared(n);
        if (!(area_i > 0 && area_j > 0 && area_i + area_j < all)) {
            plain = false;
            return;
        }
        keep((dot(n, newest_) / all) * n, 2, i, j);
    }
    void faces()
    {
        const V3 ab = cross(way_[0], way_[1]), bc = cross(way_[1], way_[2]), ca = cross(way_[2], way_[0]);
        const double volume = dot(ab, way_[2]);
        if (dot(ab, newest_) * volume > 0) face(0, 1, ab);
        if (dot(bc, newest_) * volume > 0) face(1, 2, bc);
        if (dot(ca, newest_) * volume > 0) face(2, 0, ca);
        plain = plain && square < infinity; // else the origin is inside
    }

    const Corner* c_;
    V3 newest_;
    V3 way_[3];      // to the others
    double past_[3]; // how far the origin is along these, times their lengths
};

} // namespace

V3 Simplex::point() const
{
    V3 p = corners[0].weight * corners[0].w;
    for (int k = 1; k < size; ++k)
        p = p + corners[k].weight * corners[k].w;
    return p;
}

Simplex::Needed Simplex::nearest(Origin origin) const
{
    if (size == 1) return single(0);
    if (size == 2) return brink::nearest(corners, 0, 1);
    if (size == 3) return brink::nearest(corners, 0, 1, 2);
    const Needed n = nearest_of_four(corners, false);
    return n.count == 4 && origin == Origin::outside ? nearest_of_four(corners, true) : n;
}

V3 Simplex::nearest_point(const Needed& n) const
{
    const V3 a = corners[n.corner[0]].w;
    if (n.count == 1) return a;
    const V3 b = corners[n.corner[1]].w;
    if (n.count == 2) return across(across(a, b - a), b - a);
    const V3 c = corners[n.corner[2]].w;
    const V3 normal = face_normal(a, b, c);
    const double square = norm_squared(normal);
    if (square > 0) return (dot(normal, a) / square) * normal;
    return n.weight[0] * a + n.weight[1] * b + n.weight[2] * c;
}

Simplex::Taken Simplex::take_in(V3& v)
{
    const NearNewest near(corners, size);
    if (!near.plain) return Taken::unclear;
    if (!(near.square < norm_squared(v))) return Taken::no_nearer;
    v = near.v;
    const Corner& newest = corners[size];
    if (near.count == 0) {
        corners[0] = newest;
    } else if (near.count == 1) {
        if (near.first == 2) corners[1] = corners[2];
        if (const int free = near.first == 0 ? 1 : 0; free != size) corners[free] = newest;
    } else if (size == 3) {
        corners[3 - near.first - near.second] = newest;
    }
    size = near.count + 1;
    return Taken::nearer;
}

V3 Simplex::nearest_point() const
{
    Needed all{size, {0, 1, 2}, {}};
    for (int k = 0; k < size; ++k)
        all.weight[k] = corners[k].weight;
    return nearest_point(all);
}

void Simplex::weigh_all()
{
    if (size == 3) {
        const V3 a = corners[0].w, b = corners[1].w, c = corners[2].w, n = cross(b - a, c - a);
        const double area_a = dot(n, cross(b, c)), area_b = dot(n, cross(c, a)), area_c = dot(n, cross(a, b));
        const double sum = area_a + area_b + area_c;
        if (!(area_a > 0 && area_b > 0 && area_c > 0)) return reduce();
        corners[0].weight = area_a / sum;
        corners[1].weight = area_b / sum;
        corners[2].weight = area_c / sum;
    } else if (size == 1) {
        corners[0].weight = 1;
    } else {
        reduce();
    }
}

void Simplex::weigh(V3 point)
{
    if (size != 3) return;
    const V3 a = corners[0].w, b = corners[1].w, c = corners[2].w;
    const Leaning t = leaning(a, b, c);
    const V3 base = t.q - t.p, side = t.apex - t.p, height = across(side, base), on_plane = point - t.p;
    const double up = dot(across(on_plane, base), height) / norm_squared(height);
    const double on = dot(on_plane - up * side, base) / norm_squared(base);
    if (!(up >= 0 && on >= 0 && up + on <= 1)) return;
    const int first = t.p == a ? 0 : t.p == b ? 1 : 2;
    corners[first].weight = 1 - on - up;
    corners[(first + 1) % 3].weight = on;
    corners[(first + 2) % 3].weight = up;
}

void Simplex::keep(const Needed& n)
{
    size = n.count;
    for (int k = 0; k < size; ++k) {
        if (n.corner[k] != k) corners[k] = corners[n.corner[k]];
        corners[k].weight = n.weight[k];
    }
}

double Simplex::depth() const
{
    double least = infinity;
    for (int k = 0; k < 4; ++k) {
        const V3 a = corners[(k + 1) % 4].w, d = corners[k].w - a;
        const V3 n = face_normal(a, corners[(k + 2) % 4].w, corners[(k + 3) % 4].w);
        const double length = norm(n), height = dot(n, d);
        if (!(length > 0)) return -infinity;
        least = std::min(least, (height < 0 ? dot(n, a) : -dot(n, a)) / length);
    }
    return least;
}

V3 Simplex::on_a() const
{
    V3 p = corners[0].weight * corners[0].on_a;
    for (int k = 1; k < size; ++k)
        p = p + corners[k].weight * corners[k].on_a;
    return p;
}

bool Simplex::contains(const Corner& c) const
{
    for (int k = 0; k < size; ++k)
        if (corners[k].in_a == c.in_a && corners[k].in_b == c.in_b && corners[k].w == c.w) return true;
    return false;
}

} // namespace brink
