// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mover.h"

namespace brink {

/// One body at one time, seen from A's pivot with the world's axes.
template <class Part> struct Posed {
    const Part& part; // placed
    V3 pivot;
    double reach;
    V3 rate;
    double angle; // |rate|
};

/// Two bodies at time t.
template <class Part> struct Facing {
    Posed<Core> a; // its pivot is the origin
    Posed<Part> b;
    V3 velocity;   // of B's pivot relative to A's, per step
    double margin; // radii, target gap and what rounding may hide: taken off every bound
};

/// An axis between two bodies, and how fast it is to turn. Every unit axis, however found, and every rate
/// give a valid bound; good ones give long steps.
struct TurningAxis {
    V3 normal; // unit, from A towards B
    V3 spin;   // radians per step
};

/// What one axis proves.
struct Step {
    double gap = 0;      // now, between the supporting planes at right angles to it
    double length = 0;   // of time, over which the gap is proven to stay at or above zero
    double residual = 0; // about as much of the gap as the same axis leaves after it
};

/// The step that an axis proves from here; no longer than the horizon. Nothing where the gap is not positive.
template <class Part> Step safe_step(const Facing<Part>&, const TurningAxis&, double horizon);

/// The time over which the gap along an axis is proven not to fall below its value now.
template <class Part> double rising_step(const Facing<Part>&, const TurningAxis&, double horizon);

/// The time over which the gap to a border along its own axis is proven not to decrease at any moment.
double growing_step(const Facing<Border>&, const TurningAxis&, double horizon);

/// The same of the distance of two cores, which are as `now` says. Nothing where they overlap.
double growing_step(const Facing<Core>&, const TurningAxis&, const Separation& now, double horizon);

/// How fast the gap can close at most, as far as the two supporting planes at right angles to a fixed axis
/// tell, at any time; may be negative.
double closing_rate(const Facing<Core>&, V3 axis);

} // namespace brink
