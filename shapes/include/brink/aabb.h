// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/pose.h>

namespace brink {

/// Every point p with min <= p <= max in each coordinate. Unbounded sides are +-infinity.
struct Aabb {
    Vec3 min{0, 0, 0};
    Vec3 max{0, 0, 0};
};

} // namespace brink
