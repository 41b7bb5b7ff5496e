// SPDX-License-Identifier: BSD-3-Clause
#include "pairs.h"
#include "rounded_polygon.h"
#include "sharp.h"

#include <algorithm>

namespace brink {

/// A moving point against the triangle grown by the sphere's radius.
Entry sphere_triangle(const Sphere& a, const Triangle& b, const Approach& m)
{
    const Rotation turn = m.turn_b();
    const V3 corner_a = turn * load(b.a), corner_b = turn * load(b.b), corner_c = turn * load(b.c);
    const V3 centre = (1.0 / 3) * (corner_a + corner_b + corner_c);
    const double reach_squared = std::max(
        {norm_squared(corner_a - centre), norm_squared(corner_b - centre), norm_squared(corner_c - centre)});
    const double extent =
        std::sqrt(std::max({norm_squared(corner_a), norm_squared(corner_b), norm_squared(corner_c)}));
    const V3 edge_ab = corner_b - corner_a, edge_ac = corner_c - corner_a;
    const Polygon triangle{{corner_a, corner_b, corner_c, corner_a},
                           {edge_ab, corner_c - corner_b, -edge_ac, {}},
                           careful_cross(edge_ab, edge_ac),
                           centre,
                           std::sqrt(reach_squared),
                           false};
    const Reach r = reach(m, a.radius + m.target_gap, extent);
    const auto later = [&](V3 axis, double t) {
        return sharp::later(a, b, m, axis, two_sum(a.radius, m.target_gap), r.lengths + extent, t);
    };
    return polygon_entry(triangle, m, r, later).entry;
}

} // namespace brink
