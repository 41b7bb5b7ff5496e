// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"
#include "simplex.h"

namespace brink {

/// Where two cores come nearest, radii left out, as far as GJK could tell and was asked to.
struct Closest {
    Closest() {}              // NOLINT(modernize-use-equals-default): as in Core
    bool certain = false;     // lower and upper bound of the distance agree within the slack asked for
    bool inside = false;      // the simplex of four holds the origin, rounding left out: the cores overlap
    V3 point_a;               // on A, always: upper bounds of the distance come from points
    V3 v;                     // from point_a to a point of B
    V3 normal;                // unit; the axis of `lower`; zero where none was found
    double lower = -infinity; // the gap between the supporting planes at right angles to `normal`
    Simplex simplex;          // whose nearest point v is
};

/// How near the two bounds of a distance must come.
struct Nearness {
    double slack = 0;        // length
    double relative = 0;     // part of what the distance has beyond `reach`
    double reach = 0;        // length
    double apart = infinity; // length: of cores proven to be farther apart the axis will do, without points
};

/// The algorithm of Gilbert, Johnson and Keerthi (1988), as van den Bergen tells it (Collision Detection in
/// Interactive 3D Environments, 2003), with two differences. It ends on every input: each round strictly
/// shortens v, else it stops. And it believes no answer but one whose supporting planes confirm it within
/// what is asked; else it says so, and the caller takes the long way. It begins with `start`, unless that is
/// empty: corners of both cores as they lie now. The cores must be scaled so that products of five lengths
/// neither overflow nor vanish.
Closest gjk(const Core& a, const Core& b, Nearness, const Simplex& start = {});

} // namespace brink
