// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector.h"

namespace brink {

/// Where a ray from the origin meets a triangle or a segment.
struct RayEntry {
    double t = infinity; // in lengths of the direction; infinity where it does not
    V3 weights;          // of the corners: not negative, their sum is 1
};

/// The least t >= 0 with t * direction in the triangle pqr, seen from both sides, edges and corners included.
/// A ray in its plane meets its edge, a degenerate triangle is a segment or a point: both are hit if the ray
/// meets them exactly. (Signs of volumes as in T. Moller and B. Trumbore, Fast, Minimum Storage Ray/Triangle
/// Intersection, 1997.) Lengths such that products of six neither overflow nor vanish.
RayEntry ray_triangle(V3 direction, V3 p, V3 q, V3 r);

} // namespace brink
