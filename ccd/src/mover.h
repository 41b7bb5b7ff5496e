// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"
#include "trig.h"
#include "vector.h"

#include <brink/motion.h>

namespace brink {

/// A constant turn: axis times angle over the whole step.
struct Turn {
    V3 rate;          // rotation vector; radians per step
    V3 axis{0, 0, 1}; // unit
    double angle = 0; // |rate|
};

Turn turn(const Vec3& rotation);
/// exp(t [rate]x)
Rotation turned(const Turn&, double t);

/// A vector that turns about an axis: what stays, what turns with the cosine and what with the sine.
struct Turning {
    V3 still, cosine, sine;

    V3 at(SinCos a) const { return still + a.cos * cosine + a.sin * sine; }
};

/// A moving shape about its pivot: `Part` is Core (bounded) or Border (plane or half-space), in world axes at
/// t = 0 and with the pivot as origin.
template <class Part> struct Mover {
    Part part;
    V3 position; // of the body, world
    V3 arm;      // from there to the pivot
    V3 translation;
    Turn turn;          // none where turning changes nothing: a point on its pivot
    double reach = 0;   // from the pivot to the farthest point of the core; 0 for a plane or half-space
    Turning vectors[4]; // of a part that turns: its corners or else its axes and centre; a border's normal

    V3 pivot(double t) const { return position + (arm + t * translation); }
    /// Puts a copy of the part where it is at t, its pivot at `at`.
    void place(Part& copy, double t, V3 at) const;
    Part turned_to(double t) const
    {
        Part copy = part;
        place(copy, t, {});
        return copy;
    }
};

/// A shape seen from itself, on its way.
Mover<Core> mover(const Core&, const Motion&);
Mover<Border> mover(const Border&, const Motion&);

static inline Core part(const Sphere& s) { return core(s); }
static inline Core part(const Capsule& s) { return core(s); }
static inline Core part(const Box& s) { return core(s); }
static inline Core part(const Triangle& s) { return core(s); }
static inline Border part(const Plane& s) { return border(s); }
static inline Border part(const HalfSpace& s) { return border(s); }
static inline Core part(const Cylinder& s) { return core(s); }
static inline Core part(const Cone& s) { return core(s); }
static inline Core part(const Ellipsoid& s) { return core(s); }
static inline Core part(const Hull& s) { return core(s); }

template <class Shape> auto mover(const Shape& s, const Motion& m) { return mover(part(s), m); }

} // namespace brink
