// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gjk.h"
#include "sat.h"

namespace brink {

/// An axis, what it is worth, and where the cores come nearest if that is a point or a line of the
/// difference.
struct LocalTop {
    Axis axis;
    bool top = false; // the gap is within the slack of the largest nearby, as far as slopes tell
    V3 point_a, v;    // a point of A and what leads from there to one of B
};

/// An axis along which the gap between two cores, of which one is round, is locally the largest, from one
/// that is near. Newton's method on the plane of directions about it, the second derivatives from differences
/// of supporting points; where those jump across a ridge, because a straight line of the difference lies
/// against the plane, the axis is made to stand upright on it and goes on along the ridge. A step over a
/// ridge goes back to where it crossed it. Never worse than the axis given by more than the slack.
LocalTop locally_best(const Core& a, const Core& b, const Axis& start, double slack);
/// The same, but no farther than until the gap and the distance of the points agree as nearly as asked, of
/// cores apart: whether they do is `top`, and without it the rest is of no use.
LocalTop nearly_best(const Core& a, const Core& b, V3 start, const Nearness&);

} // namespace brink
