// SPDX-License-Identifier: BSD-3-Clause
#include "pairs.h"
#include "rounded_polygon.h"

namespace brink {

/// Only the sum of the radii matters: A shrinks to its centre and B grows, which leaves a moving point and
/// one capsule (Ericson, Real-Time Collision Detection, 2005).
Entry sphere_capsule(const Sphere& a, const Capsule& b, const Approach& m)
{
    const Rotation turn = m.turn_b();
    const V3 ends[] = {turn * load(b.a), turn * load(b.b)};
    return outline_entry(ends, m.from, m.by, a.radius + b.radius + m.target_gap);
}

} // namespace brink
