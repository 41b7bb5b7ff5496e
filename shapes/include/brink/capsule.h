// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/pose.h>

namespace brink {

/// Every point within `radius` of the segment from `a` to `b` (local frame). All finite, radius >= 0.
/// `a == b` is a sphere and a zero radius a segment: both are legal.
struct Capsule {
    Vec3 a{0, 0, 0};
    Vec3 b{0, 0, 0};
    double radius = 0;
};

} // namespace brink
