// SPDX-License-Identifier: BSD-3-Clause
#include "border_entry.h"
#include "pairs.h"

#include <algorithm>

namespace brink {

Entry capsule_half_space(const Capsule& a, const HalfSpace& b, const Approach& m)
{
    const Rotation turn = m.turn_a();
    const V3 start = turn * load(a.a), end = turn * load(a.b), ends[] = {m.from + start, m.from + end};
    const double extent = std::sqrt(std::max(norm_squared(start), norm_squared(end)));
    return border_entry(ends, border_of(b, m), m, a.radius + m.target_gap, extent);
}

} // namespace brink
