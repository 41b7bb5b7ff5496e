// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace brink {

/// Every point within `radius` of the local origin. radius >= 0; a zero radius is a point, which is legal.
struct Sphere {
    double radius = 0;
};

} // namespace brink
