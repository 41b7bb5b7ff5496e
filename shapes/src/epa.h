// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"

namespace brink {

/// How deep two cores overlap, radii left out, as far as is proven.
struct Penetration {
    /// Minus how far B must move along `normal` to be clear of A, for certain up to rounding: a lower bound
    /// of the signed distance, by the supporting planes. Positive where the cores are apart after all.
    double lower = -infinity;
    double gap = 0; // an upper bound of it, equal to `lower` up to the slack unless the room ran out
    V3 normal;      // unit, from A towards B
    V3 point_a;     // on A,
    V3 v;           // and what leads from there to a point of B: as short as known
};

/// The expanding polytope algorithm (G. van den Bergen, Proximity Queries and Penetration Depth Computation
/// on 3D Game Objects, 2001), with two differences. It starts from corners of the difference that lie far
/// apart, whether or not the origin is between them: where it is not, the face that it is farthest beyond is
/// the first to grow. And what grows is a closed surface by construction, whatever rounding decides: the
/// faces seen from a new corner make way for a cone over their border. Needs no memory but the stack's. The
/// cores must be scaled so that products of five lengths neither overflow nor vanish.
Penetration penetration(const Core& a, const Core& b, double slack);

/// The same of cores, at least one of them round, that are known to be apart: where the polytope comes
/// nearest to the origin, found as GJK finds it, but with all that it saw on the way.
Penetration separation_by_growth(const Core& a, const Core& b, double slack);

} // namespace brink
