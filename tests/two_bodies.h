// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "certificate.h"
#include "support/random.h"

#include <algorithm>
#include <variant>

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

/// The least gap at 65 times from t on.
template <class Part> double least_gap(const TwoBodies<Part>& bodies, double t, double length)
{
    double least = infinity;
    for (int k = 0; k <= 64; ++k)
        least = std::min(least, bodies.at(t + length * k / 64).gap);
    return least;
}

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

inline Box random_box(support::Random& random)
{
    const double x = random.chance(0.1) ? 0 : random.between(0.01, 1), y = random.between(0.01, 1);
    const double z = random.log_between(1e-3, 4);
    return {Vec3(x, y, z)};
}

/// At rest, glued to either body, or anything.
inline V3 any_spin(support::Random& random, const TwoBodies<Core>& s)
{
    const V3 any = load(random.in_cube(4));
    const int choice = random.index(4);
    return choice == 0 ? V3{} : choice == 1 ? s.a.turn.rate : choice == 2 ? s.b.turn.rate : any;
}

/// A segment, cylinder, cone, ellipsoid or, half of the time, a box: some of them flat or long.
inline Shape random_shape(support::Random& random, int kind)
{
    const double radius = random.log_between(0.01, 1), half_length = random.log_between(0.01, 2);
    const Box box = random_box(random);
    switch (kind) {
    case 0:
        return Capsule{Vec3(0, 0, -half_length), Vec3(0.1, 0, half_length), 0};
    case 1:
        return Cylinder{half_length, radius};
    case 2:
        return Cone{half_length, radius};
    case 3:
        return Ellipsoid{box.half_extents};
    default:
        return box;
    }
}

inline Mover<Core> moving_core(const Shape& shape, const Motion& motion)
{
    if (const auto* s = std::get_if<Capsule>(&shape)) return mover(*s, motion);
    if (const auto* s = std::get_if<Cylinder>(&shape)) return mover(*s, motion);
    if (const auto* s = std::get_if<Cone>(&shape)) return mover(*s, motion);
    if (const auto* s = std::get_if<Ellipsoid>(&shape)) return mover(*s, motion);
    return mover(std::get<Box>(shape), motion);
}

/// Two bodies of the i-th pair of kinds.
inline TwoBodies<Core> random_bodies(support::Random& random, int i, double reach)
{
    const Shape a = random_shape(random, i % 8), b = random_shape(random, i / 8 % 8);
    const Motion motion_a = random_motion(random, reach), motion_b = random_motion(random, reach);
    return {moving_core(a, motion_a), moving_core(b, motion_b)};
}

/// Two bodies of the i-th pair of kinds, a time, and an axis with a spin: often the best one.
struct AnyMoment {
    TwoBodies<Core> bodies;
    double t;
    TurningAxis axis;
};
inline AnyMoment any_moment(support::Random& random, int i)
{
    const TwoBodies<Core> bodies = random_bodies(random, i, 3);
    const double t = random.between(0, 0.9);
    const bool best_axis = random.chance(0.7);
    const V3 any = load(random.unit()), spin = any_spin(random, bodies);
    return {bodies, t, {best_axis ? bodies.at(t).normal : any, spin}};
}

} // namespace brink
