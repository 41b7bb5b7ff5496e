// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <limits>

namespace brink {

using Vec3 = Eigen::Vector3d;
/// Unaligned, so that the layout does not depend on the caller's machine flags.
using Quat = Eigen::Quaternion<double, Eigen::DontAlign>;

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where a body is: world = position + orientation * local. Scene length units.
///
/// The orientation q stands for the rotation M(q) / |q|^2 with M the usual quadratic form of a quaternion;
/// it is accepted when | |q|^2 - 1 | <= 1e-6, so single-precision quaternions may be passed as they are.
struct Pose {
    Vec3 position{0, 0, 0};
    Quat orientation{1, 0, 0, 0}; // w, x, y, z

    static Pose from(const Eigen::Isometry3d&);
    Eigen::Isometry3d isometry() const;
};
static_assert(sizeof(Pose) == 56 && alignof(Pose) == 8);

} // namespace brink
