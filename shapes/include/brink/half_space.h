// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/pose.h>

namespace brink {

/// Solid where normal . x <= offset (local frame). The normal is accepted when | |normal|^2 - 1 | <= 1e-6,
/// and distances are divided by its length.
struct HalfSpace {
    Vec3 normal{0, 0, 1};
    double offset = 0;
};

} // namespace brink
