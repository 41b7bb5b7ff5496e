// SPDX-License-Identifier: BSD-3-Clause
#include "pairs.h"
#include "rounded_polygon.h"
#include "sharp.h"

#include <algorithm>

namespace brink {

/// Only the sum of the radii matters: A shrinks to its centre and B grows, which leaves a moving point and
/// one capsule (Ericson, Real-Time Collision Detection, 2005).
Entry sphere_capsule(const Sphere& a, const Capsule& b, const Approach& m)
{
    const Rotation turn = m.turn_b();
    const V3 start = turn * load(b.a), end = turn * load(b.b);
    const double extent = std::sqrt(std::max(norm_squared(start), norm_squared(end)));
    const Reach r = reach(m, a.radius + b.radius + m.target_gap, extent);
    return segment_entry(start, end, m, r, [&](V3 axis, double t) {
        const Pair radius = two_sum(a.radius, b.radius) + Pair{m.target_gap};
        return sharp::later(a, b, m, axis, radius, r.lengths + extent, t);
    });
}

} // namespace brink
