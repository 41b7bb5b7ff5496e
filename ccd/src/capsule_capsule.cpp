// SPDX-License-Identifier: BSD-3-Clause
#include "pairs.h"
#include "segments.h"
#include "sharp.h"

#include <algorithm>

namespace brink {

Entry capsule_capsule(const Capsule& a, const Capsule& b, const Approach& m)
{
    const Rotation turn_a = m.turn_a(), turn_b = m.turn_b();
    const V3 a0 = turn_a * load(a.a), a1 = turn_a * load(a.b);
    const V3 b0 = turn_b * load(b.a), b1 = turn_b * load(b.b);
    const double extents = std::sqrt(std::max(norm_squared(a0), norm_squared(a1))) +
                           std::sqrt(std::max(norm_squared(b0), norm_squared(b1)));
    const Reach r = reach(m, a.radius + b.radius + m.target_gap, extents);
    return segments_entry({a0, a1 - a0}, {b0, b1 - b0}, m, r, [&](V3 axis, double t) {
        const Pair radius = two_sum(a.radius, b.radius) + Pair{m.target_gap};
        return sharp::later(a, b, m, axis, radius, r.lengths + extents, t);
    });
}

} // namespace brink
