// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sat.h"

namespace brink {

struct LocalTop {
    Axis axis;
    bool top; // whether the gap is within some slack of the largest nearby, as far as its slope tells
};

/// An axis along which the gap between two cores, of which one is round, is locally the largest, from one
/// that is near: Newton's method on the plane of directions about it, with the second derivatives from
/// differences of supporting points. Never worse than the axis given.
LocalTop locally_best(const Core& a, const Core& b, const Axis& start, double slack);

} // namespace brink
