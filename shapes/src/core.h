// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector.h"

#include <brink/shape.h>

namespace brink {

/// A bounded shape as the solvers see it: a core (a point, a segment, a triangle or a box) and the radius
/// that is grown around it, placed in some common frame. Radii only ever appear as a sum.
struct Core {
    enum class Kind : unsigned char { point, segment, triangle, box };
    Kind kind = Kind::point;
    int count = 1; // points
    V3 points[8];  // corners; box: corner k has +x where k & 1, +y where k & 2, +z where k & 4, else -
    double radius = 0;
    // Boxes only: where it is flat its corners no longer tell its axes.
    V3 centre, half_extents;
    Rotation axes;
};

/// The core of a bounded shape in its local frame. Not for Plane and HalfSpace.
Core core(const Sphere&);
Core core(const Capsule&);
Core core(const Box&);
Core core(const Triangle&);

/// The same core, turned about the origin and then shifted.
Core placed(const Core&, const Rotation&, V3 position);

/// A plane or half-space in some common frame: normal . x = offset, or <=. The normal is a unit vector.
struct Border {
    V3 normal{0, 0, 1};
    double offset = 0;
    bool solid = false; // half-space
};

Border border(const Plane&);
Border border(const HalfSpace&);
Border placed(const Border&, const Rotation&, V3 position);

/// How far apart two placed shapes are, radii included, as certified as doubles allow.
struct Separation {
    /// A lower bound of the true gap up to rounding: the distance between the two supporting planes at right
    /// angles to `normal`. Where GJK is exact it equals `gap` to a few ulp of the scale.
    double lower = 0;
    double gap = 0; // between the witness points; minus the penetration depth when the shapes overlap
    V3 normal;      // unit, from A towards B
    V3 point_a;     // on the surface of A
    V3 point_b;     // on the surface of B
};

/// The same answer with A and B exchanged.
static inline Separation flipped(const Separation& s)
{
    return {s.lower, s.gap, -s.normal, s.point_b, s.point_a};
}

Separation separation(const Core& a, const Core& b);
Separation separation(const Core& a, const Border& b);

} // namespace brink
