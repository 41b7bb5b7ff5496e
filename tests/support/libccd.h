// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/shape.h>

namespace brink::support {

/// Whether libccd can be asked: two of sphere, capsule, box, triangle.
bool libccd_trusts(const Shape& a, const Shape& b);

/// libccd's two booleans: whether the shapes overlap. Near touching they are coin tosses.
bool libccd_gjk_overlap(const Shape& a, const Pose&, const Shape& b, const Pose&);
bool libccd_mpr_overlap(const Shape& a, const Pose&, const Shape& b, const Pose&);

} // namespace brink::support
