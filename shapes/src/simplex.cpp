// SPDX-License-Identifier: BSD-3-Clause
#include "simplex.h"

namespace brink {

namespace {

using Corner = Simplex::Corner;

Corner weighted(Corner c, double weight)
{
    c.weight = weight;
    return c;
}

Simplex single(const Corner& a) { return {1, {weighted(a, 1)}}; }

/// The point of the edge between a and b at t of the way.
Simplex edge(const Corner& a, const Corner& b, double t) { return {2, {weighted(a, 1 - t), weighted(b, t)}}; }

Simplex nearest(const Corner& a, const Corner& b)
{
    const V3 e = b.w - a.w;
    const double past_a = -dot(a.w, e), before_b = dot(b.w, e);
    if (!(past_a > 0)) return single(a);
    if (!(before_b > 0)) return single(b);
    return edge(a, b, past_a / (past_a + before_b));
}

/// Ericson, Real-Time Collision Detection, 2005: the nearest point of a triangle by Voronoi regions.
Simplex nearest(const Corner& a, const Corner& b, const Corner& c)
{
    const V3 ab = b.w - a.w, ac = c.w - a.w;
    const double ab_a = -dot(ab, a.w), ac_a = -dot(ac, a.w);
    if (ab_a <= 0 && ac_a <= 0) return single(a);
    const double ab_b = -dot(ab, b.w), ac_b = -dot(ac, b.w);
    if (ab_b >= 0 && ac_b <= ab_b) return single(b);
    const double ab_c = -dot(ab, c.w), ac_c = -dot(ac, c.w);
    if (ac_c >= 0 && ab_c <= ac_c) return single(c);

    const double area_c = ab_a * ac_b - ab_b * ac_a;
    if (area_c <= 0 && ab_a > 0 && ab_b < 0) return edge(a, b, ab_a / (ab_a - ab_b));
    const double area_b = ab_c * ac_a - ab_a * ac_c;
    if (area_b <= 0 && ac_a > 0 && ac_c < 0) return edge(a, c, ac_a / (ac_a - ac_c));
    const double area_a = ab_b * ac_c - ab_c * ac_b;
    const double from_b = ac_b - ab_b, from_c = ab_c - ac_c;
    if (area_a <= 0 && from_b > 0 && from_c > 0) return edge(b, c, from_b / (from_b + from_c));

    const double sum = area_a + area_b + area_c;
    if (!(area_a > 0 && area_b > 0 && area_c > 0)) return single(a);
    return {3, {weighted(a, area_a / sum), weighted(b, area_b / sum), weighted(c, area_c / sum)}};
}

/// Whether the plane through a, b and c keeps the origin apart from d.
bool separates(const Corner& a, const Corner& b, const Corner& c, const Corner& d)
{
    const V3 n = cross(b.w - a.w, c.w - a.w);
    return dot(n, d.w - a.w) * dot(n, a.w) >= 0;
}

Simplex nearer(const Simplex& s, const Simplex& t)
{
    return norm_squared(t.point()) < norm_squared(s.point()) ? t : s;
}

/// The face opposite to the newest corner d was the simplex before it: the origin lies on d's side of that.
Simplex nearest(const Corner& a, const Corner& b, const Corner& c, const Corner& d)
{
    Simplex best;
    if (separates(a, b, d, c)) best = nearest(a, b, d);
    if (separates(b, c, d, a)) best = best.size == 0 ? nearest(b, c, d) : nearer(best, nearest(b, c, d));
    if (separates(c, a, d, b)) best = best.size == 0 ? nearest(c, a, d) : nearer(best, nearest(c, a, d));
    if (best.size > 0) return best;
    return {4, {a, b, c, d}};
}

} // namespace

V3 Simplex::point() const
{
    V3 p = corners[0].weight * corners[0].w;
    for (int k = 1; k < size; ++k)
        p = p + corners[k].weight * corners[k].w;
    return p;
}

bool Simplex::contains(const Corner& corner) const
{
    const bool by_place = corner.in_a < 0 || corner.in_b < 0;
    for (int k = 0; k < size; ++k) {
        const Corner& c = corners[k];
        if (by_place ? c.w == corner.w : c.in_a == corner.in_a && c.in_b == corner.in_b) return true;
    }
    return false;
}

Simplex Simplex::with(const Corner& corner) const
{
    Simplex s = *this;
    s.corners[s.size++] = corner;
    return s;
}

Simplex Simplex::reduced() const
{
    const Corner* c = corners;
    switch (size) {
    case 1:
        return single(c[0]);
    case 2:
        return nearest(c[0], c[1]);
    case 3:
        return nearest(c[0], c[1], c[2]);
    default:
        return nearest(c[0], c[1], c[2], c[3]);
    }
}

} // namespace brink
