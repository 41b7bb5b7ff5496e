// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "certificate.h"

namespace brink {

/// The same bodies, seen from the other's pivot where one does not turn: any of its points will do for it.
template <class Part> Facing<Part> about_one_pivot(const Facing<Part>&);

/// What safe_step proves, point by point: each bends away from its own line no more than its own distance
/// from the pivot lets it. Far longer where a body rocks on a point that stays near the other one, and as
/// much work as there are corners. The axis of a plane or half-space is its own, with its rate.
template <class Part> Step corner_step(const Facing<Part>&, const TurningAxis&, double horizon);

/// The same with two points that end it: where they are now; they go with their bodies.
struct Blocked {
    Step step;
    V3 on_a, on_b;
};
Blocked blocked_step(const Facing<Core>&, const TurningAxis&, double horizon);

/// The step that an axis at rest proves whatever the bodies' turns: no point leaves its circle.
Step whirl_step(const Facing<Core>&, V3 normal, double horizon);

/// The time over which the gap along an axis is proven, point by point, not to fall below its value now.
template <class Part> double corner_rise(const Facing<Part>&, const TurningAxis&, double horizon);

} // namespace brink
