// SPDX-License-Identifier: BSD-3-Clause
#include "pairs.h"
#include "rounded_polygon.h"

namespace brink {

/// Only the sum of the radii matters: A shrinks to its centre and B grows, which leaves a moving point and
/// one capsule (Ericson, Real-Time Collision Detection, 2005).
Entry sphere_capsule(const Sphere& a, const Capsule& b, const Approach& m)
{
    const Rotation turn = m.turn_b();
    const double radius = a.radius + b.radius + m.target_gap;
    return segment_entry(turn * load(b.a), turn * load(b.b), m.from, m.by, radius);
}

} // namespace brink
