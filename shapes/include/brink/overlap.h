// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/shape.h>

#include <optional>

namespace brink {

/// Whether two posed shapes share a point. Shapes are closed: touching counts. True for invalid input, the
/// safe side, and for two unbounded shapes.
bool overlaps(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b);

} // namespace brink
