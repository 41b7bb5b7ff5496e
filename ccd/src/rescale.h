// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "approach.h"
#include "scaling.h"
#include "support.h"
#include "toi_query.h"
#include "tolerance.h"

#include <algorithm>
#include <limits>

/// Queries in other length units: everything but the times times a power of two.
namespace brink {

static inline Vec3 scaled(const Vec3& v, int e) { return store(scaled(load(v), e)); }
static inline Sphere scaled(const Sphere& s, int e) { return {std::ldexp(s.radius, e)}; }
static inline Capsule scaled(const Capsule& s, int e)
{
    return {scaled(s.a, e), scaled(s.b, e), std::ldexp(s.radius, e)};
}
static inline Box scaled(const Box& s, int e) { return {scaled(s.half_extents, e)}; }
static inline Triangle scaled(const Triangle& s, int e)
{
    return {scaled(s.a, e), scaled(s.b, e), scaled(s.c, e)};
}
static inline Plane scaled(const Plane& s, int e) { return {s.normal, std::ldexp(s.offset, e)}; }
static inline HalfSpace scaled(const HalfSpace& s, int e) { return {s.normal, std::ldexp(s.offset, e)}; }

static inline Cylinder scaled(const Cylinder& s, int e)
{
    return {std::ldexp(s.half_length, e), std::ldexp(s.radius, e)};
}
static inline Cone scaled(const Cone& s, int e)
{
    return {std::ldexp(s.half_length, e), std::ldexp(s.radius, e)};
}

static inline Motion scaled(const Motion& m, int e)
{
    return {{scaled(m.start.position, e), m.start.orientation},
            scaled(m.translation, e),
            m.rotation,
            scaled(m.pivot, e)};
}

static inline Options scaled(const Options& options, int e)
{
    Options out = options;
    out.target_gap = std::ldexp(options.target_gap, e);
    out.tolerance = std::min(std::ldexp(options.tolerance, e), std::numeric_limits<double>::max());
    return out;
}

static inline Toi scaled(const Toi& toi, int e)
{
    Toi out = toi;
    out.point_a = scaled(toi.point_a, e);
    out.point_b = scaled(toi.point_b, e);
    out.gap = std::ldexp(toi.gap, e);
    return out;
}

static inline double largest(const Vec3& v) { return largest_coordinate(load(v)); }
static inline double largest(const Sphere& s) { return s.radius; }
static inline double largest(const Capsule& s) { return std::max({largest(s.a), largest(s.b), s.radius}); }
static inline double largest(const Box& s) { return largest(s.half_extents); }
static inline double largest(const Triangle& s)
{
    return std::max({largest(s.a), largest(s.b), largest(s.c)});
}
static inline double largest(const Plane& s) { return std::fabs(s.offset); }
static inline double largest(const HalfSpace& s) { return std::fabs(s.offset); }
static inline double largest(const Cylinder& s) { return std::max(s.half_length, s.radius); }
static inline double largest(const Cone& s) { return std::max(s.half_length, s.radius); }
static inline double largest(const Ellipsoid& s) { return largest(s.radii); }
static inline double largest(const Hull& s) { return extent(core(s)); }
static inline double largest(const Motion& m)
{
    return std::max({largest(m.start.position), largest(m.translation), largest(m.pivot)});
}

/// The power of two that brings a length near 1 where it is far from that; else 0.
static inline int exponent_to_usual(double most)
{
    const bool usual =
        most == 0 || (most > tolerance::smallest_lengths && most < tolerance::largest_lengths / 64);
    return usual ? 0 : -exponent(most);
}

/// That of a valid query's largest length.
template <class A, class B> int exponent_to_usual(const A& a, const B& b, const Query& q)
{
    return exponent_to_usual(
        std::max({largest(a), largest(b), largest(q.motion_a), largest(q.motion_b), q.options.target_gap}));
}

/// The same for bodies that only translate, of which pivots and common offsets do not matter.
template <class A, class B> int exponent_to_usual(const A& a, const B& b, const Query& q, const Approach& m)
{
    const double most = std::max(
        {largest(a), largest(b), largest_coordinate(m.from), largest_coordinate(m.by), q.options.target_gap});
    return most < infinity ? exponent_to_usual(most) : exponent_to_usual(a, b, q);
}

/// Whether positions and motions still are numbers in lengths times 2^exponent.
static inline bool can_be_scaled(const Query& q, int exponent)
{
    return std::ldexp(std::max(largest(q.motion_a), largest(q.motion_b)), exponent) <
           tolerance::largest_position;
}

} // namespace brink
