// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "certificate.h"
#include "support/random.h"

/// Two moving bodies as the certificates see them.
namespace brink {

/// Starts anywhere in the cube of half edge `reach`, goes as far as 2 along each axis and turns by anything
/// up to 8 radians, half of the time about a pivot off its centre.
inline Motion random_motion(support::Random& random, double reach)
{
    Motion m;
    m.start.position = random.in_cube(reach);
    m.start.orientation = random.rotation();
    m.translation = random.in_cube(2);
    const double angle = random.log_between(1e-3, 8);
    const Vec3 axis = random.unit();
    m.rotation = Vec3(angle * axis.x(), angle * axis.y(), angle * axis.z());
    if (random.chance(0.5)) m.pivot = random.in_cube(1);
    return m;
}

/// A body and another one, or a plane or half-space.
template <class Part> struct TwoBodies {
    Mover<Core> a;
    Mover<Part> b;

    /// From A's pivot to B's.
    V3 offset(double t) const
    {
        return (b.position - a.position) + (b.arm - a.arm) + t * (b.translation - a.translation);
    }
    Separation at(double t) const
    {
        return separation(a.turned_to(t), placed(b.turned_to(t), {}, offset(t)));
    }
};

/// The two at one time, and what a certificate asks of them.
template <class Part> struct Moment {
    Core a;
    Part b;
    V3 offset;
    const TwoBodies<Part>& bodies;

    Moment(const TwoBodies<Part>& moving, double t)
        : a(moving.a.turned_to(t)),
          b(placed(moving.b.turned_to(t), {}, moving.offset(t))),
          offset(moving.offset(t)),
          bodies(moving)
    {
    }
    Facing<Part> facing() const
    {
        return {{a, {}, bodies.a.reach, bodies.a.turn.rate, bodies.a.turn.angle},
                {b, offset, bodies.b.reach, bodies.b.turn.rate, bodies.b.turn.angle},
                bodies.b.translation - bodies.a.translation,
                0};
    }
};

} // namespace brink
