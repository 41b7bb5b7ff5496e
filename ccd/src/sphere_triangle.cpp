// SPDX-License-Identifier: BSD-3-Clause
#include "pairs.h"
#include "rounded_polygon.h"

#include <algorithm>

namespace brink {

/// A moving point against the triangle grown by the sphere's radius.
Entry sphere_triangle(const Sphere& a, const Triangle& b, const Approach& m)
{
    const Rotation turn = m.turn_b();
    const V3 la = load(b.a), lb = load(b.b), lc = load(b.c);
    Polygon<3> p{{turn * la, turn * lb, turn * lc}, turn * careful_cross(lb - la, lc - la), {}, 0};
    p.centre = (1.0 / 3) * (p.corner[0] + p.corner[1] + p.corner[2]);
    p.reach = std::sqrt(std::max({norm_squared(p.corner[0] - p.centre), norm_squared(p.corner[1] - p.centre),
                                  norm_squared(p.corner[2] - p.centre)}));
    return polygon_entry(p, m.from, m.by, a.radius + m.target_gap);
}

} // namespace brink
