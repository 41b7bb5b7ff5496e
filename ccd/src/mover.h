// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"
#include "lanes.h"
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
/// exp(t [rate]x); or by the sine and cosine of t |rate|.
Rotation turned(const Turn&, double t);
Rotation turned(const Turn&, SinCos);

/// Two vectors that turn about an axis: what stays, what turns with the cosine and what with the sine.
struct Turning {
    Turning() {} // NOLINT(modernize-use-equals-default): as in Core
    Turning(const XYZ<Two>& vectors, const Turn&);
    XYZ<Two> still, cosine, sine;

    XYZ<Two> at(SinCos a) const { return still + both(a.cos) * cosine + both(a.sin) * sine; }
};

static inline Core part(const Sphere& s) { return core(s); }
static inline Core part(const Capsule& s) { return core(s); }
static inline Core part(const Box& s) { return core(s); }
static inline Core part(const Triangle& s) { return core(s); }
static inline Border part(const Plane& s) { return border(s); }
static inline Border part(const HalfSpace& s) { return border(s); }
/// A core that has no more than one extent as the segment or point that it is, whose ends are corners.
Core thinned(const Core& round);
static inline Core part(const Cylinder& s) { return thinned(core(s)); }
static inline Core part(const Cone& s) { return thinned(core(s)); }
static inline Core part(const Ellipsoid& s) { return thinned(core(s)); }
static inline Core part(const Hull& s) { return core(s); }

/// A moving shape about its pivot: `Part` is Core (bounded) or Border (plane or half-space), in world axes at
/// t = 0 and with the pivot as origin.
template <class Part> struct Mover {
    /// A shape seen from itself, on its way.
    Mover(const Part& local, const Motion& m) : part(local) { set_out(m); }
    template <class Shape> Mover(const Shape& s, const Motion& m) : part(brink::part(s)) { set_out(m); }

    Part part;
    V3 position; // of the body, world
    V3 arm;      // from there to the pivot
    V3 translation;
    Turn turn;          // none where turning changes nothing: a point on its pivot
    double reach = 0;   // from the pivot to the farthest point of the core; 0 for a plane or half-space
    Turning vectors[2]; // of a part that turns: its corners or else its axes and centre; a border's normal

    V3 pivot(double t) const { return position + (arm + t * translation); }
    /// Puts a copy of the part where it is at t, its pivot at `at`; `turned` are the sine and cosine of the
    /// angle by then.
    void place(Part& copy, SinCos turned, V3 at) const;
    Part turned_to(double t) const
    {
        Part copy = part;
        place(copy, sin_cos(t * turn.angle), {});
        return copy;
    }

private:
    void set_out(const Motion&);
};

static inline Mover<Core> mover(const Core& local, const Motion& m) { return {local, m}; }
static inline Mover<Border> mover(const Border& local, const Motion& m) { return {local, m}; }
template <class Shape> auto mover(const Shape& s, const Motion& m) { return Mover<decltype(part(s))>(s, m); }

} // namespace brink
