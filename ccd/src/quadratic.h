// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lanes.h"

#include <brink/pose.h>

namespace brink {

/// First t >= 0 at which a t^2 + 2 b t + c has fallen to zero, given its discriminant b^2 - a c and a >= 0: 0
/// when it starts there, infinite when it never does. The root is c over a sum of two positive numbers, so
/// nothing cancels.
static inline Two first_root(Two b, Two c, Two discriminant)
{
    const TwoFlags meets = (b < 0) & (discriminant >= 0);
    const Two root = c / (square_root(discriminant) - b); // NaN where it does not meet
    return select(c <= 0, both(0), select(meets, root, both(infinity)));
}

/// First t >= 0 with |from + t by| <= radius; 0 when already so, infinite when never.
///
/// The discriminant is taken as a R^2 - |from x by|^2, which unlike b^2 - a c keeps the closest approach
/// to a few eps |from|, however far away the start is.
static inline Two ray_ball(XYZ<Two> from, XYZ<Two> by, Two radius)
{
    const Two reach_squared = radius * radius, c = norm_squared(from) - reach_squared;
    const Two discriminant = norm_squared(by) * reach_squared - norm_squared(cross(from, by));
    return first_root(dot(from, by), c, discriminant);
}
static inline double ray_ball(V3 from, V3 by, double radius)
{
    return ray_ball(both(from), both(by), both(radius))[0];
}

} // namespace brink
