// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/pose.h>

namespace brink {

/// Every point with (x / radii.x)^2 + (y / radii.y)^2 + (z / radii.z)^2 <= 1 (local frame). Radii >= 0 and
/// finite: a zero one makes an elliptic disc, two a segment, three a point, all of which are legal.
struct Ellipsoid {
    Vec3 radii{0, 0, 0};
};

} // namespace brink
