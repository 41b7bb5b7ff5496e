// SPDX-License-Identifier: BSD-3-Clause
#include "gjk.h"

#include "nearest.h"
#include "simplex.h"
#include "support.h"

namespace brink {

namespace {

/// Enough for any two boxes many times over; v shortens in every round, so it cannot be reached by cycling.
constexpr int most_rounds = 64;

Simplex::Corner corner_towards_origin(const Core& a, const Core& b, V3 v)
{
    const SupportPoint on_a = farthest(a, v), on_b = farthest(b, -v);
    return {on_b.point - on_a.point, on_a.point, on_a.corner, on_b.corner, 1};
}

V3 witness(const Simplex& s)
{
    V3 p = s.corners[0].weight * s.corners[0].on_a;
    for (int k = 1; k < s.size; ++k)
        p = p + s.corners[k].weight * s.corners[k].on_a;
    return p;
}

/// The corners of one core that a simplex uses, each once.
struct Feature {
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
V3 feature_normal(const Core& a, const Core& b, const Simplex& s, V3 v)
{
    if (!is_polytope(a) || !is_polytope(b)) return v;
    Feature of_a, of_b;
    for (int k = 0; k < s.size; ++k)
        of_a.add(corner(a, s.corners[k].in_a)), of_b.add(corner(b, s.corners[k].in_b));
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

/// The answer with n, in either sense, for its normal, if that confirms it.
Closest confirmed(const Core& a, const Core& b, Closest c, V3 n, double slack)
{
    const double length = norm(n), distance = norm(c.v);
    if (!(length > 0)) return c;
    n = (dot(n, c.v) < 0 ? -1 / length : 1 / length) * n;
    c.lower = gap_along(a, b, n);
    c.normal = n;
    // The second test keeps v along n where the distance hardly depends on the place of the witness points.
    c.certain = distance - c.lower <= slack && norm(c.v - distance * n) <= slack;
    return c;
}

} // namespace

Closest gjk(const Core& a, const Core& b, double slack)
{
    Simplex simplex{1, {corner_towards_origin(a, b, middle(b) - middle(a))}};
    V3 v = simplex.point();
    for (int round = 0; round < most_rounds; ++round) {
        const double square = norm_squared(v), distance = std::sqrt(square);
        if (!(distance > slack)) break;
        const Simplex::Corner corner = corner_towards_origin(a, b, v);
        const double lower = dot(v, corner.w) / distance;
        if (distance - lower <= slack) return {true, witness(simplex), v, (1 / distance) * v, lower};
        if (simplex.contains(corner)) break;
        const Simplex next = simplex.with(corner).reduced();
        if (next.size == 4) return {false, witness(simplex), v, {}, 0};
        const V3 next_v = next.point();
        if (!(norm_squared(next_v) < square)) break;
        simplex = next;
        v = next_v;
    }
    const Closest found{false, witness(simplex), v, {}, 0};
    return confirmed(a, b, found, feature_normal(a, b, simplex, v), slack);
}

} // namespace brink
