// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "random.h"

#include <brink/shape.h>

/// The shapes and orientations that queries are made of.
namespace brink::support {

enum class ShapeStyle : unsigned char {
    any,     // zero sizes, needles, flat boxes, degenerate triangles, normals slightly off unit among them
    aligned, // edges and faces along the local axes, so that equal orientations make them parallel
    integer, // quarters of small integers, so that touching can be exact
};

/// `kind` is the index in the Shape variant.
Shape draw_shape(Random&, std::size_t kind, ShapeStyle);

/// A few centimetres across; planes and half-spaces as they come.
Shape small_shape(Random&, std::size_t kind);

/// A box 3 across and 1 cm thick, along any of its axes.
Box thin_wall(Random&);

/// Anything from the identity and quarter turns to random, some rounded to float or a little off unit.
Quat draw_orientation(Random&);

/// Turned first, in its own frame, by a small rotation vector: to first order, in radians.
Quat turned_by(const Quat&, const Vec3& turn);

/// Turned from the given orientation by nothing or 1e-1 to 1e-14.
Quat nearly(Random&, const Quat&);

/// Each coordinate a quarter of an integer in [-n, n].
Vec3 draw_integers(Random&, int n);

} // namespace brink::support
