// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace brink {

/// The convex hull of the point (0, 0, half_length) and the disc of `radius` about (0, 0, -half_length) at
/// right angles to z (local frame). Both >= 0 and finite. A zero half length makes a disc, a zero radius a
/// segment: all are legal.
struct Cone {
    double half_length = 0;
    double radius = 0;
};

} // namespace brink
