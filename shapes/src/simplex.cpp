// SPDX-License-Identifier: BSD-3-Clause
#include "simplex.h"

#include "nearest.h"

#include <brink/shape.h>

#include <algorithm>

namespace brink {

namespace {

using Corner = Simplex::Corner;

/// Which corners the nearest point needs, a bit each, and their weights: 0 for the others.
struct Weights {
    unsigned used = 0;
    double of[4] = {};
};

Weights single(int a)
{
    Weights w{1U << a};
    w.of[a] = 1;
    return w;
}

/// The point of the edge between a and b at t of the way.
Weights edge(int a, int b, double t)
{
    Weights w{1U << a | 1U << b};
    w.of[a] = 1 - t;
    w.of[b] = t;
    return w;
}

Weights nearest(const Corner* c, int a, int b)
{
    const V3 e = c[b].w - c[a].w;
    const double past_a = -dot(c[a].w, e), before_b = dot(c[b].w, e);
    if (!(past_a > 0)) return single(a);
    if (!(before_b > 0)) return single(b);
    return edge(a, b, past_a / (past_a + before_b));
}

/// Ericson, Real-Time Collision Detection, 2005: the nearest point of a triangle by Voronoi regions.
Weights nearest(const Corner* corners, int i, int j, int k)
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
    Weights w{1U << i | 1U << j | 1U << k};
    w.of[i] = area_a / sum;
    w.of[j] = area_b / sum;
    w.of[k] = area_c / sum;
    return w;
}

/// Whether the plane through a, b and c keeps the origin apart from d.
bool separates(const Corner& a, const Corner& b, const Corner& c, const Corner& d)
{
    const V3 n = cross(b.w - a.w, c.w - a.w);
    return dot(n, d.w - a.w) * dot(n, a.w) >= 0;
}

double square_at(const Corner* c, const Weights& w)
{
    V3 p{};
    for (int k = 0; k < 4; ++k)
        if ((w.used >> k & 1U) != 0) p = p + w.of[k] * c[k].w;
    return norm_squared(p);
}

constexpr unsigned all_four = 15;

/// The face opposite to the newest corner was the simplex before it: the origin lies on the newest's side of
/// that. Of the other three, those that keep the origin apart, or simply all.
template <class Apart> Weights nearest(const Corner* c, Apart apart)
{
    Weights best;
    constexpr int faces[3][3] = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    constexpr int opposite[3] = {2, 0, 1};
    for (int f = 0; f < 3; ++f) {
        const int i = faces[f][0], j = faces[f][1], k = faces[f][2];
        if (!apart(c[i], c[j], c[k], c[opposite[f]])) continue;
        const Weights w = nearest(c, i, j, k);
        if (best.used == 0 || square_at(c, w) < square_at(c, best)) best = w;
    }
    if (best.used == 0) best.used = all_four;
    return best;
}

Weights nearest(const Simplex& s)
{
    switch (s.size) {
    case 1:
        return single(0);
    case 2:
        return nearest(s.corners, 0, 1);
    case 3:
        return nearest(s.corners, 0, 1, 2);
    default:
        return nearest(s.corners, separates);
    }
}

} // namespace

V3 Simplex::point() const
{
    V3 p = corners[0].weight * corners[0].w;
    for (int k = 1; k < size; ++k)
        p = p + corners[k].weight * corners[k].w;
    return p;
}

V3 Simplex::nearest_point() const
{
    const V3 a = corners[0].w;
    if (size == 2) return across(across(a, corners[1].w - a), corners[1].w - a);
    if (size != 3) return point();
    const V3 n = face_normal(a, corners[1].w, corners[2].w);
    const double square = norm_squared(n);
    return square > 0 ? (dot(n, a) / square) * n : point();
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
        if (corners[k].w == c.w && corners[k].in_a == c.in_a && corners[k].in_b == c.in_b) return true;
    return false;
}

void Simplex::reduce() { reduce(Origin::anywhere); }
void Simplex::reduce_outside() { reduce(Origin::outside); }

void Simplex::reduce(Origin origin)
{
    Weights w = nearest(*this);
    if (w.used == all_four && origin == Origin::outside)
        w = nearest(corners, [](const Corner&, const Corner&, const Corner&, const Corner&) { return true; });
    int kept = 0;
    for (int k = 0; k < size; ++k) {
        if ((w.used >> k & 1U) == 0) continue;
        if (kept != k) corners[kept] = corners[k];
        corners[kept++].weight = w.of[k];
    }
    size = kept;
}

} // namespace brink
