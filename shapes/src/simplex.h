// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector.h"

namespace brink {

/// Up to four corners of the difference B - A, and the weights that make the point of their hull which is
/// nearest to the origin. Weights are never negative and sum to 1, so that the point lies in the hull
/// whatever rounding did.
struct Simplex {
    struct Corner {
        V3 w;                     // the point of B less that of A
        V3 on_a;                  // the latter
        int in_a = -1, in_b = -1; // which corners they are, if any
        double weight = 0;
    };
    int size = 0;
    Corner corners[4];

    /// The point that the weights stand for.
    [[nodiscard]] V3 point() const;
    [[nodiscard]] bool contains(const Corner&) const;
    /// One corner more; fewer than four before.
    [[nodiscard]] Simplex with(const Corner&) const;
    /// The same hull's nearest point to the origin, and only the corners that it needs: four only where the
    /// origin is inside. The last corner must be the newest one.
    [[nodiscard]] Simplex reduced() const;
};

} // namespace brink
