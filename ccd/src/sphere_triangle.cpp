// SPDX-License-Identifier: BSD-3-Clause
#include "pairs.h"
#include "rounded_polygon.h"

#include <algorithm>

namespace brink {

/// A moving point against the triangle grown by the sphere's radius.
Entry sphere_triangle(const Sphere& a, const Triangle& b, const Approach& m)
{
    const Rotation turn = m.turn_b();
    const V3 local[] = {load(b.a), load(b.b), load(b.c)};
    const V3 normal = turn * cross(local[1] - local[0], local[2] - local[0]);
    const V3 corners[] = {turn * local[0], turn * local[1], turn * local[2]};
    const V3 centre = (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
    const double reach_squared =
        std::max({norm_squared(corners[0] - centre), norm_squared(corners[1] - centre),
                  norm_squared(corners[2] - centre)});
    return polygon_entry(corners, normal, centre, std::sqrt(reach_squared), m.from, m.by,
                         a.radius + m.target_gap);
}

} // namespace brink
