// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"

namespace brink {

/// Two nearest points: v leads from point_a, on A, to its nearest of B.
struct NearestPair {
    double square = infinity; // |v|^2
    V3 point_a, v;
};

/// A core of at most eight corners and those of them that are asked about, a bit each. An edge counts when
/// both its ends do.
struct Patch {
    const Core& core;
    unsigned corners = ~0U;
};

/// The nearest of all corners of one patch against the other core and all edges against edges, each in closed
/// form. That is the distance between the cores, radii left out, when they do not overlap. Long (some
/// microseconds for two boxes) but with nothing in it that could go astray.
NearestPair nearest_features(const Patch& a, const Patch& b);

/// A few corners of a polytope: those that lie foremost along n.
struct Foremost {
    Foremost(const Core&, V3 n);
    static constexpr int most = 8;
    int count = 0;
    V3 points[most];
};

/// The same of the hulls of such corners, whatever their features are: every point against every triangle,
/// and every segment against every other.
NearestPair nearest_features(const Foremost& a, const Foremost& b);

} // namespace brink
