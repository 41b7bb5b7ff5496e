// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"

#include <optional>

namespace brink {

/// A valid shape at a pose, seen from `origin` with the world's axes, in lengths times 2^exponent.
/// Differences first: a common offset of two bodies costs nothing.
struct PlacedShape {
    bool bounded = true;
    Core core;     // if bounded
    Border border; // if not
};
PlacedShape placed_shape(const Shape&, const Pose&, V3 origin, int exponent = 0);

/// How far apart two valid shapes are, in the world. Nothing where both are unbounded.
std::optional<Separation> separation(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b);

static inline bool unbounded(const Shape& shape)
{
    return std::holds_alternative<Plane>(shape) || std::holds_alternative<HalfSpace>(shape);
}

} // namespace brink
