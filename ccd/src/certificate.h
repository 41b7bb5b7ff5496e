// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mover.h"

namespace brink {

/// What the certified steps need of one body at one time: its core about the pivot, or its plane.
struct Turning {
    const Core* core =
        nullptr;      // about the pivot, world axes; null: a plane or half-space, which `level` is of
    double level = 0; // n . x of every point of the plane, n the axis of the certificate
    double reach = 0;
    V3 rate;
};

/// Two bodies at time t and an axis between them. Every unit axis n, however found, bounds the gap from below
/// by the two planes at right angles to it that support the bodies.
struct Facing {
    Turning a, b;
    V3 axis;     // unit, from A towards B
    V3 offset;   // from A's pivot to B's at time t
    V3 velocity; // of B's pivot relative to A's, per step
    double gap;  // what is proven to lie between the supporting planes at time t, rounding already taken off
};

/// A step h in [0, horizon] over which the gap is proven to stay at or above zero; 0 when nothing is proven.
double safe_step(const Facing&, double horizon);

/// A step h in [0, horizon] over which the gap is proven not to fall below its value now.
double rising_step(const Facing&, double horizon);

} // namespace brink
