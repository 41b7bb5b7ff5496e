// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sight.h"

/// Looks that a closed form answers.
namespace brink {

/// Points or segments.
Sight look_at_segments(const Facing<Core>&);
/// A, a point or segment, and a box.
Sight look_at_thin_box(const Facing<Core>&);
/// A, a point, and a cylinder or cone.
Sight look_at_point_round(const Facing<Core>&);

} // namespace brink
