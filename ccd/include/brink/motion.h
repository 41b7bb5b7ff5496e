// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/shape.h>

namespace brink {

/// How a body moves over one step, t in [0, 1].
///
/// The pivot moves in a straight line while the body turns about it with constant angular velocity:
/// pivot(t) = start * pivot + t * translation, orientation(t) = exp(t [rotation]x) * start.orientation.
struct Motion {
    Pose start{};
    Vec3 translation{0, 0, 0}; // of the pivot, over the whole step; scene length units
    Vec3 rotation{0, 0, 0}; // rotation vector over the whole step: world axis * angle in radians, up to 2^20
    Vec3 pivot{0, 0, 0};    // local point that moves in a straight line (the centre of mass)

    /// The pose at time t: the rounding of the exact motion, each coordinate of the position off by at most
    /// 16 eps (|start.position| + |translation| + (1 + |rotation|) |pivot|), the orientation by 8 eps (1 +
    /// |rotation|).
    Pose at(double t) const;
    static Motion still(const Pose&);
    /// From one pose to another by the shorter turn about `pivot` (local).
    static Motion between(const Pose& from, const Pose& to, const Vec3& pivot = Vec3{0, 0, 0});
};
static_assert(sizeof(Motion) == 128 && alignof(Motion) == 8);

/// A box that contains the moving shape at every t in [0, t_max], whatever its rotation and pivot.
/// All of space where an input is invalid.
Aabb swept_bounds(const Shape&, const Motion&, double t_max = 1);

} // namespace brink
