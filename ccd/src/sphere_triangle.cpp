// SPDX-License-Identifier: BSD-3-Clause
#include "pairs.h"
#include "rounded_polygon.h"

#include <algorithm>

namespace brink {

/// A moving point against the triangle grown by the sphere's radius.
Entry sphere_triangle(const Sphere& a, const Triangle& b, const Approach& m)
{
    const Rotation turn = m.turn_b();
    const V3 local = load(b.a), edge_b = load(b.b) - local, edge_c = load(b.c) - local;
    const V3 corner_a = turn * local, corner_b = turn * load(b.b), corner_c = turn * load(b.c);
    const V3 centre = (1.0 / 3) * (corner_a + corner_b + corner_c);
    const double reach_squared = std::max(
        {norm_squared(corner_a - centre), norm_squared(corner_b - centre), norm_squared(corner_c - centre)});
    const Polygon triangle{{corner_a, corner_b, corner_c, corner_a},
                           turn * careful_cross(edge_b, edge_c),
                           centre,
                           std::sqrt(reach_squared)};
    return polygon_entry(triangle, m.from, m.by, a.radius + m.target_gap).entry;
}

} // namespace brink
