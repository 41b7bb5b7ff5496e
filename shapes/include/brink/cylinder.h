// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace brink {

/// Every point with |z| <= half_length and x^2 + y^2 <= radius^2 (local frame): flat ends, along z. Both
/// >= 0 and finite. A zero half length makes a disc, a zero radius a segment: all are legal.
struct Cylinder {
    double half_length = 0;
    double radius = 0;
};

} // namespace brink
