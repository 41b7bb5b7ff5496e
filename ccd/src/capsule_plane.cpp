// SPDX-License-Identifier: BSD-3-Clause
#include "border_entry.h"
#include "pairs.h"

namespace brink {

Entry capsule_plane(const Capsule& a, const Plane& b, const Approach& m)
{
    const Rotation turn = m.turn_a();
    const V3 ends[] = {m.from + turn * load(a.a), m.from + turn * load(a.b)};
    return border_entry(ends, border_of(b, m), m.by, a.radius + m.target_gap);
}

} // namespace brink
