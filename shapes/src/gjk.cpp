// SPDX-License-Identifier: BSD-3-Clause
#include "gjk.h"

#include "nearest.h"
#include "support.h"

#include <algorithm>

namespace brink {

namespace {

/// Enough for any two polytopes many times over; v shortens in every round, so it cannot be reached by
/// cycling. Smooth shapes get nearer by a digit or more in a few rounds.
constexpr int most_rounds = 128;

/// Only near the distance can a corner turn up again: before, nobody has to look.
constexpr double nearly_there = 0.99;

void put_corner_of_others(Simplex::Corner& c, const Core& a, const Core& b, const V3& v)
{
    const SupportPoint on_a = farthest(a, v), on_b = farthest(b, -v);
    c.w = on_b.point - on_a.point;
    c.on_a = on_a.point;
    c.on_b = on_b.point;
    c.in_a = on_a.corner;
    c.in_b = on_b.corner;
    c.weight = 1;
}

/// The corner of the difference B - A that lies farthest against v.
void put_corner(Simplex::Corner& c, const Core& a, const Core& b, const V3& v)
{
    const bool hulls = a.kind == Core::Kind::hull && b.kind == Core::Kind::hull;
    return hulls ? put_corner_of_hulls(c, a, b, v) : put_corner_of_others(c, a, b, v);
}

/// The different corners of one core that a simplex uses.
struct Used {
    int count = 0;
    V3 points[4];
    void add(V3 p)
    {
        for (int k = 0; k < count; ++k)
            if (points[k] == p) return;
        points[count++] = p;
    }
};

/// The direction that the features at the two ends of v ask for: v itself is rounding noise when it is short.
V3 feature_normal(const Simplex& s, V3 v)
{
    Used of_a, of_b;
    for (int k = 0; k < s.size; ++k)
        of_a.add(s.corners[k].on_a), of_b.add(s.corners[k].on_b);
    if (of_a.count >= 3) return face_normal(of_a.points[0], of_a.points[1], of_a.points[2]);
    if (of_b.count >= 3) return face_normal(of_b.points[0], of_b.points[1], of_b.points[2]);
    if (of_a.count == 2 && of_b.count == 2) {
        const V3 n = common_normal(of_a.points[1] - of_a.points[0], of_b.points[1] - of_b.points[0]);
        if (!(n == V3{})) return n;
    }
    if (of_a.count == 2) return across(v, of_a.points[1] - of_a.points[0]);
    if (of_b.count == 2) return across(v, of_b.points[1] - of_b.points[0]);
    return v;
}

/// Takes n, in either sense, for the normal where it proves more than what was found on the way, and believes
/// it if it confirms the distance.
void confirm(Closest& c, const Core& a, const Core& b, V3 n, double slack)
{
    const double length = norm(n), distance = norm(c.v);
    if (!(length > 0)) return;
    n = (dot(n, c.v) < 0 ? -1 / length : 1 / length) * n;
    const double lower = gap_along(a, b, n);
    if (!(lower >= c.lower)) return;
    c.lower = lower;
    c.normal = n;
    // The second test keeps v along n where the distance hardly depends on the place of the witness points.
    c.certain = distance - c.lower <= slack && norm(c.v - distance * n) <= slack &&
                norm(c.simplex.point() - c.v) <= slack;
}

/// How far the weights of a simplex lead beside its nearest point, made better where that is too far.
double weighed(Simplex& s, V3 nearest, double enough)
{
    const double beside = norm(s.point() - nearest);
    if (beside <= enough) return beside;
    s.weigh(nearest);
    return norm(s.point() - nearest);
}

/// Finds the weights, and the nearest point as true as can be, that rounds with corners have left out.
void settle(Closest& c)
{
    c.simplex.weigh_all();
    c.v = c.simplex.nearest_point();
}

} // namespace

Closest gjk(const Core& a, const Core& b, Nearness near, const Simplex& start)
{
    // The simplices of curved surfaces are slivers: each round needs a nearest point as true as can be.
    const bool has_corners = is_polytope(a) && is_polytope(b);
    Closest c;
    Simplex& s = c.simplex;
    s.size = start.size;
    std::copy_n(start.corners, start.size, s.corners);
    if (s.size == 0) put_corner(s.corners[s.size++], a, b, middle(b) - middle(a));
    const Simplex::Needed at_first = s.nearest(Simplex::Origin::anywhere);
    c.inside = at_first.count == 4;
    if (!c.inside) c.v = s.nearest_point(at_first);
    s.keep(at_first);
    for (int round = 0; round < most_rounds && !c.inside; ++round) {
        const double square = norm_squared(c.v), distance = std::sqrt(square);
        if (!(distance > near.slack)) break;
        Simplex::Corner& corner = s.corners[s.size]; // counted as soon as it is needed
        put_corner(corner, a, b, c.v);
        const double inverse = 1 / distance, lower = inverse * dot(c.v, corner.w);
        const V3 axis = inverse * c.v;
        if (lower > c.lower) c.lower = lower, c.normal = axis;
        const auto far = [&](double upper) {
            return upper - lower > near.slack + near.relative * std::max(0.0, upper - near.reach);
        };
        if (!far(distance)) {
            if (c.lower > near.apart) return c; // from afar the axis is all that is wanted
            const double enough = near.slack + near.relative * distance;
            if (has_corners) settle(c);
            if (has_corners && far(norm(c.v))) break; // of a sliver
            c.certain = weighed(s, c.v, enough) <= enough;
            c.lower = lower;
            c.normal = axis;
            c.point_a = s.on_a();
            return c;
        }
        if (lower >= nearly_there * distance && s.contains(corner)) break;
        if (has_corners) {
            const Simplex::Taken taken = s.take_in(c.v);
            if (taken == Simplex::Taken::nearer) continue;
            if (taken == Simplex::Taken::no_nearer) break;
        }
        ++s.size;
        const Simplex::Needed next =
            s.nearest(lower > near.slack ? Simplex::Origin::outside : Simplex::Origin::anywhere);
        const V3 v = next.count < 4 ? s.nearest_point(next) : V3{};
        --s.size;
        if (next.count == 4) { // v is left from the round before
            c.point_a = s.on_a();
            c.inside = true;
            ++s.size;
            s.keep(next);
            return c;
        }
        if (!(norm_squared(v) < square)) break;
        s.keep(next);
        c.v = v;
    }
    if (!c.inside) {
        if (has_corners) settle(c);
        weighed(s, c.v, near.slack);
        confirm(c, a, b, feature_normal(s, c.v), near.slack);
    }
    c.point_a = s.on_a();
    return c;
}

} // namespace brink
