// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector.h"

#include <brink/pose.h>

namespace brink {

/// First t >= 0 at which a t^2 + 2 b t + c has fallen to zero, given its discriminant b^2 - a c and a >= 0: 0
/// when it starts there, infinite when it never does. The root is c over a sum of two positive numbers, so
/// nothing cancels. Written without branches: which way they go is what the caller does not know.
static inline double first_root(double b, double c, double discriminant)
{
    const bool meets = (b < 0) & (discriminant >= 0);
    const double root = c / (std::sqrt(meets ? discriminant : 0) - b);
    return c <= 0 ? 0 : meets ? root : infinity;
}

/// First t >= 0 with |from + t by| <= radius; 0 when already so, infinite when never.
///
/// The discriminant is taken as a R^2 - |from x by|^2, which unlike b^2 - a c keeps the closest approach
/// to a few eps |from|, however far away the start is.
static inline double ray_ball(V3 from, V3 by, double radius)
{
    const double c = norm_squared(from) - radius * radius;
    const double discriminant = norm_squared(by) * (radius * radius) - norm_squared(cross(from, by));
    return first_root(dot(from, by), c, discriminant);
}

} // namespace brink
