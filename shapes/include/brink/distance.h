// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/shape.h>
#include <brink/status.h>

#include <limits>

namespace brink {

/// How far apart two posed shapes are, and where they come nearest.
struct Distance {
    Status status = Status::invalid; // invalid, separated (gap > 0) or touching (gap <= 0)
    /// Scene length units. Below zero it is minus the penetration depth, the shortest translation that
    /// leaves the shapes just touching. NaN when invalid.
    double gap = std::numeric_limits<double>::quiet_NaN();
    Vec3 normal{0, 0, 0};  // unit, world, from A towards B; zero only where none is defined
    Vec3 point_a{0, 0, 0}; // on A, world
    Vec3 point_b{0, 0, 0}; // on B, world: point_b - point_a = gap * normal
};

/// The gap between two posed shapes. Two unbounded shapes (plane, half-space) against each other are invalid.
Distance distance(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b);

} // namespace brink
