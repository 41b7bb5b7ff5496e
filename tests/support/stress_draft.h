// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "draw.h"
#include "path.h"

/// What the classes of stress.h are drawn from.
namespace brink::support {

/// A query before it is assembled.
struct Draft {
    Shape a, b;
    Quat turned_a, turned_b;
    Path path;
    Vec3 base{0, 0, 0};
    Vec3 common{0, 0, 0}; // velocity that both have
    double share = 1;     // of the relative motion, that A has
    double target_gap = 0;
};

Query assemble(const Draft&);

/// Every length times s.
Shape scaled(Shape, double s);
Draft scaled(Draft, double s);

Vec3 rotated(const Quat&, const Vec3&);

/// From `distance` away towards somewhere near B. Ground is approached from near, whatever the distance.
Draft draft(Random&, const Pair&, ShapeStyle, double distance);

/// No difficulty.
Draft plain(Random&, const Pair&);

/// A point of a shape's core, the body at rest at the origin.
Vec3 core_point(Random&, const Shape&, const Quat& orientation);

/// The same with A's radius chosen so that the gap at the start is `gap` plus `times` what the motion closes
/// in the step. Unchanged where no radius does it.
Query brought_near(const Query&, double gap, double times);

} // namespace brink::support
