// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/pose.h>

#include <cmath>

namespace brink::support {

/// The shortest turn of one direction onto another, to the bit that of Eigen's FromTwoVectors unless they are
/// opposite. Eigen's brings its decompositions of matrices: 10 to 30 seconds to compile wherever it is
/// called.
inline Quat turn_onto(const Vec3& from, const Vec3& to)
{
    const Vec3 a = from.normalized(), b = to.normalized();
    const double c = b.dot(a);
    const Vec3 across = a.unitOrthogonal();
    if (c < 1e-12 - 1) return Quat(0, across.x(), across.y(), across.z());
    const double twice_w = std::sqrt((1 + c) * 2);
    const Vec3 v = a.cross(b) * (1 / twice_w);
    return Quat(0.5 * twice_w, v.x(), v.y(), v.z());
}

} // namespace brink::support
