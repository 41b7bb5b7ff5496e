// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"

namespace brink {

/// How far a point is from a cylinder or a cone, negative inside, and the direction in which it comes nearer.
struct FromPoint {
    enum class To : unsigned char { corner, side, end }; // corner: rim or apex
    double gap = 0;
    V3 normal; // unit
    To to = To::corner;
};

/// In the core's own frame, by its section through the axis and the point. |point| and the sizes such that
/// squares keep their digits; the answer has lost them where the point lies on the surface.
FromPoint from_point(V3 point, const Core& cylinder_or_cone);

} // namespace brink
