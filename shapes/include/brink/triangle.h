// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/pose.h>

namespace brink {

/// The convex hull of three points (local frame), seen from both sides. Collinear or equal corners are legal
/// and mean a segment or a point.
struct Triangle {
    Vec3 a{0, 0, 0};
    Vec3 b{0, 0, 0};
    Vec3 c{0, 0, 0};
};

} // namespace brink
