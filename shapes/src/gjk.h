// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"

namespace brink {

/// Where two cores come nearest, radii left out, as far as GJK could tell.
struct Closest {
    bool certain = false; // lower and upper bound of the distance agree within the slack asked for
    V3 point_a;           // on A, always: upper bounds of the distance come from points
    V3 v;                 // from point_a to a point of B
    V3 normal;            // unit; the axis of `lower`. Only where certain.
    double lower = 0;     // the gap between the supporting planes at right angles to `normal`
};

/// The algorithm of Gilbert, Johnson and Keerthi (1988), as van den Bergen tells it (Collision Detection in
/// Interactive 3D Environments, 2003), with two differences. It ends on every input: each round strictly
/// shortens v, else it stops. And it believes no answer but one whose supporting planes confirm it within
/// `slack`; else it says so, and the caller takes the long way. The cores must be scaled so that products of
/// five lengths neither overflow nor vanish.
Closest gjk(const Core& a, const Core& b, double slack);

} // namespace brink
