// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/pose.h>

namespace brink {

/// The set normal . x = offset (local frame), seen from both sides; a body that crosses it has a gap of minus
/// the least push that clears either side. The normal is accepted when | |normal|^2 - 1 | <= 1e-6, and
/// distances are divided by its length.
struct Plane {
    Vec3 normal{0, 0, 1};
    double offset = 0;

    /// The plane through three points, its normal along (b - a) x (c - a). For collinear points, or points
    /// that are not finite, the normal is zero, which every query answers with `invalid`.
    static Plane through(const Vec3& a, const Vec3& b, const Vec3& c);
};

} // namespace brink
