// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dyadic.h"
#include "whole_turn.h"

#include <brink/shape.h>

/// A moving point against the rounded difference of two cores, in exact numbers.
namespace brink::exact {

/// Limbs of a number: they hold every polynomial here for spheres over all of double's range, and for the
/// others while lengths differ by less than 1e400 and quaternion components by less than 1e100.
inline constexpr int capacity = 256;
using Number = Dyadic<capacity>;
using Point = XYZ<Number>;

using Turn = WholeTurn<Number>;

Point point(const Vec3& v, int shift);

/// The corners, edges and faces of B's core minus A's, multiplied by a common positive factor as everything
/// is that it is compared with.
struct Polytope {
    Point corner[8];
    int corners = 0;
    signed char edge[12][2]{}; // corners
    int edges = 0;
    signed char face[6][4]{}; // corners, counter-clockwise or clockwise
    int faces = 0, face_corners = 4;
    bool solid = false; // the box |x| <= corner[7]

    Point edge_vector(int i) const { return corner[edge[i][1]] - corner[edge[i][0]]; }
};

/// A corner, a segment, a triangle, a parallelogram (corners in turn) and a box about the origin.
Polytope polytope(const Point&);
Polytope polytope(const Point& a, const Point& b);
Polytope polytope(const Point& a, const Point& b, const Point& c);
Polytope polytope(const Point& a, const Point& b, const Point& c, const Point& d);
Polytope box(const Point& half_extents);

/// A point on its way, and how near counts as contact (squared).
struct Path {
    Point from, by;
    Number reach_squared;
};

/// Whether the point comes within reach of the polytope by `time`. True or false, never rounded: a segment
/// and a polytope come nearest at features, whose distances are ratios of whole numbers.
bool meets(const Polytope&, const Path&, const Number& time);

/// When the path enters each corner's ball, each edge's cylinder without ends and each face's slab without
/// sides, to `exact_root`, in no order. First contact, if any, is one of them unless it is at the start.
struct EntryTimes {
    double t[26];
    int count = 0;
};
EntryTimes entry_times(const Polytope&, const Path&);

/// c / (sqrt(disc factor) - b), each term known exactly; infinite when b >= 0 or disc < 0. factor >= 0.
double root(const Number& b, const Number& c, const Number& disc, const Number& factor);
/// (h^2 - reach^2) / ((|h| + reach) g): from height h > reach >= 0 down to reach at the rate g > 0.
double descent(const Number& height, const Number& reach_squared, const Number& rate);

} // namespace brink::exact
