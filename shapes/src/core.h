// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector.h"

#include <brink/shape.h>

namespace brink {

/// A bounded shape as the solvers see it: a core and the radius that is grown around it, placed in some
/// common frame. Radii only ever appear as a sum.
struct Core {
    enum class Kind : unsigned char { point, segment, triangle, box, hull, cylinder, cone, ellipsoid };
    Core() {} // NOLINT(modernize-use-equals-default): of a constant g++ makes a slow `rep stos`
    Kind kind = Kind::point;
    int count = 1; // corners; 0 where there is no end of them: cylinder, cone and ellipsoid
    V3 points[3];  // the corners of a point, segment or triangle
    double radius = 0;
    // Where the others are. A cylinder's and a cone's half extents are {radius, radius, half length}, with z
    // along their axis; an ellipsoid's are its radii. A hull's corners are axes * local corner + centre, the
    // axes times a power of two, its unit of length.
    V3 centre, half_extents;
    Rotation axes;
    const HullData* hull = nullptr;
};

/// The core of a bounded shape in its local frame. Not for Plane and HalfSpace.
Core core(const Sphere&);
Core core(const Capsule&);
Core core(const Box&);
Core core(const Triangle&);
Core core(const Cylinder&);
Core core(const Cone&);
Core core(const Ellipsoid&);
/// The hull must outlive it. That of fewer than four points is a point, a segment or a triangle.
Core core(const Hull&);

/// The same core, turned about the origin and then shifted.
Core placed(const Core&, const Rotation&, V3 position);

/// The same core in lengths times 2^exponent.
Core scaled(const Core&, int exponent);

/// A plane or half-space in some common frame: normal . x = offset, or <=. The normal is a unit vector.
struct Border {
    V3 normal{0, 0, 1};
    double offset = 0;
    bool solid = false; // half-space
};

Border border(const Plane&);
Border border(const HalfSpace&);
Border placed(const Border&, const Rotation&, V3 position);
Border scaled(const Border&, int exponent);

/// How far apart two placed shapes are, radii included, as certified as doubles allow.
struct Separation {
    /// A lower bound of the true gap up to rounding: the distance between the two supporting planes at right
    /// angles to `normal`. Where GJK is exact it equals `gap` to a few ulp of the scale.
    double lower = 0;
    double gap = 0; // between the witness points; minus the least depth known when the shapes overlap
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
