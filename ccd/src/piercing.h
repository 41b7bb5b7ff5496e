// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "certificate.h"

namespace brink {

/// A point of one body, seen from the frame of another that turns: its velocity, and a bound of its
/// acceleration.
struct Drift {
    V3 velocity;
    double acceleration;
};
/// `velocity` is that of the one's pivot relative to the other's; the point comes no farther than `farthest`
/// from that.
template <class Of, class From>
Drift drift(const Posed<Of>& of, const Posed<From>& from, V3 velocity, V3 point, double farthest)
{
    const V3 arm = point - of.pivot, seen = cross(of.rate, arm) + velocity;
    const double speed = of.angle * norm(arm) + norm(velocity);
    return {seen - cross(from.rate, point - from.pivot),
            of.angle * of.angle * norm(arm) + 2 * from.angle * speed + from.angle * from.angle * farthest};
}

/// One body whose core reaches into that of another.
struct Piercing {
    const Posed<Core>&of, &solid;
    V3 velocity;    // of its pivot relative to the other's
    V3 outward;     // unit: the shortest way out of the other
    double overlap; // how long that is
    double horizon;
};

/// As long as some point of the one stays inside the other, at most the horizon: the one given; the deepest
/// between that and where the one is nearest to the other's middle; or one that moves along an edge, a side
/// or a rim to where that will be deepest when contact is likely to end. 0 where nothing is proven.
double piercing_step(const Piercing&, V3 point);

} // namespace brink
