// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/pose.h>

namespace brink {

/// Every point with |x| <= half_extents.x, and so on (local frame). Half extents >= 0: a zero one makes a
/// rectangle, two a segment, three a point, all of which are legal.
struct Box {
    Vec3 half_extents{0, 0, 0};
};

} // namespace brink
