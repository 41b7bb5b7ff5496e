// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "course.h"
#include "flattest_edge.h"

namespace brink {

/// What was seen to touch, taken along by the bodies: two points, and an edge of each.
class Touching {
public:
    Touching(const Facing<Core>&, const Separation& contact);
    /// To where the course is about to go.
    void go(const Facing<Core>& from, const Course<Core>::Later& to);
    /// The time, at most the horizon, over which contact proves to last.
    double step(const Facing<Core>&, double reach, double horizon) const;

private:
    V3 on_a_, on_b_; // of the cores
    FlatEdge edge_a_, edge_b_;
};

/// A body lies where it does over a plane.
class TouchingBorder {
public:
    TouchingBorder(const Facing<Border>&, const Separation&) {}
    void go(const Facing<Border>&, const Course<Border>::Later&) {}
    static double step(const Facing<Border>&, double reach, double horizon);
};

} // namespace brink
