// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "approach.h"
#include "hull_data.h"
#include "scaling.h"
#include "toi_query.h"
#include "tolerance.h"
#include "valid_motion.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

/// What is looked at before a query is answered: all of it with care, or the usual case at a glance.
namespace brink {

/// The shape that the table's row or column says it is.
template <class Shape> static inline const Shape& as(const brink::Shape& shape)
{
    const Shape* s = std::get_if<Shape>(&shape);
    if (!s) __builtin_unreachable();
    return *s;
}

static inline bool valid(const Options& o)
{
    return o.t_max >= 0 && o.t_max <= 1 && is_size(o.target_gap) && is_size(o.tolerance) &&
           o.max_iterations >= 1 && o.start_contact <= StartContact::ignore && o.detail <= Detail::time_only;
}

template <class A, class B> static inline bool valid(const Query& q)
{
    return valid(q.options) && valid(as<A>(q.a), q.motion_a) && valid(as<B>(q.b), q.motion_b);
}

static inline double radius(const Sphere& s) { return s.radius; }
static inline double radius(const Capsule& s) { return s.radius; }
template <class Shape> static inline double radius(const Shape&) { return 0; }

/// The radius of a ball about the origin that holds the shape, but for rounding.
static inline double held(const Sphere& s) { return s.radius; }
static inline double held(const Capsule& s)
{
    return std::sqrt(std::max(norm_squared(load(s.a)), norm_squared(load(s.b)))) + s.radius;
}
static inline double held(const Box& s) { return norm(load(s.half_extents)); }
static inline double held(const Triangle& s)
{
    return std::sqrt(std::max({norm_squared(load(s.a)), norm_squared(load(s.b)), norm_squared(load(s.c))}));
}
static inline double held(const Cylinder& s) { return norm(V3{s.half_length, s.radius, 0}); }
static inline double held(const Cone& s) { return norm(V3{s.half_length, s.radius, 0}); }
static inline double held(const Ellipsoid& s) { return largest_coordinate(load(s.radii)); }
static inline double held(const Hull& s)
{
    const HullData* data = s.data();
    return data ? data->unit * (norm(data->middle) + data->ball) : 0;
}

static inline double sum(const Vec3& v) { return sum_of_magnitudes(load(v)); }
static inline double size(const Sphere& s) { return s.radius; }
static inline double size(const Capsule& s) { return sum(s.a) + sum(s.b) + s.radius; }
static inline double size(const Box& s) { return sum(s.half_extents); }
static inline double size(const Triangle& s) { return sum(s.a) + sum(s.b) + sum(s.c); }
static inline double size(const Plane& s) { return std::fabs(s.offset); }
static inline double size(const HalfSpace& s) { return std::fabs(s.offset); }
static inline double size(const Cylinder& s) { return s.half_length + s.radius; }
static inline double size(const Cone& s) { return s.half_length + s.radius; }
static inline double size(const Ellipsoid& s) { return sum(s.radii); }
static inline double size(const Hull& s) { return s.data() ? s.data()->unit * s.data()->reach : 0; }
static inline double size(const Motion& m)
{
    return sum(m.start.position) + sum(m.translation) + sum(m.pivot);
}

/// The lengths that matter to bodies which only translate, added up.
template <class A, class B> static inline double lengths(const Query& q, const Approach& m)
{
    return sum_of_magnitudes(m.from) + sum_of_magnitudes(m.by) + size(as<A>(q.a)) + size(as<B>(q.b)) +
           m.target_gap;
}

/// All of them, without a branch for each.
template <class... Flag> static inline bool all(Flag... flags)
{
    return (static_cast<int>(flags) & ...) != 0;
}

/// Whether products of lengths stay far from both ends of the range of doubles. A sum of which that cannot be
/// said says nothing about which length is to blame, or that one is not finite.
static inline bool of_usual_scale(double lengths)
{
    return all(lengths > tolerance::smallest_lengths, lengths < tolerance::largest_lengths);
}

/// Not negative (nor -0), not NaN and at most `most`: one comparison, because such doubles sort like their
/// bits.
static inline bool up_to(double most, double x)
{
    return std::bit_cast<std::uint64_t>(x) <= std::bit_cast<std::uint64_t>(most);
}
/// Nonzero in some bit but the sign.
static inline std::uint64_t any_bit(const Vec3& v)
{
    const double* c = v.data();
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
    return (bits(c[0]) | bits(c[1]) | bits(c[2])) << 1U;
}

/// turns() by the bits: what translates is not to wait for it.
template <class Shape> [[gnu::always_inline]] static inline bool seen_turning(const Shape&, const Motion& m)
{
    const bool rotates = any_bit(m.rotation) != 0;
    if constexpr (std::is_same_v<Shape, Sphere>)
        return all(rotates, any_bit(m.pivot) != 0);
    else
        return rotates;
}

/// Whether the largest of up to 2^10 lengths, which add up to this, needs no scaling (rescale.h).
static inline bool of_turning_scale(double lengths)
{
    return all(lengths > 0x1p10 * tolerance::smallest_lengths, lengths < tolerance::largest_lengths / 64);
}

/// What a shape's own check asks besides finite lengths.
static inline bool sized(const Sphere& s) { return up_to(tolerance::largest_lengths, s.radius); }
static inline bool sized(const Capsule& s) { return up_to(tolerance::largest_lengths, s.radius); }
static inline bool sized(const Triangle&) { return true; }
static inline bool sized(const Box& s)
{
    constexpr double most = tolerance::largest_lengths;
    return all(up_to(most, s.half_extents.x()), up_to(most, s.half_extents.y()),
               up_to(most, s.half_extents.z()));
}
template <class Shape> static inline bool sized(const Shape& s) { return valid(s); }

/// Whether a body is seen at a glance to translate only, and to be valid but for lengths that are not finite.
template <class Shape> [[gnu::always_inline]] static inline bool translates(const Shape& s, const Motion& m)
{
    if constexpr (std::is_same_v<Shape, Sphere>)
        return all(sized(s), any_bit(m.pivot) == 0, sum(m.rotation) <= largest_rotation);
    else
        return all(sized(s), valid(m.start.orientation), any_bit(m.rotation) == 0,
                   finite_probe(load(m.pivot)) == 0);
}
static inline bool usual(const Options& o)
{
    return all(up_to(1, o.t_max), up_to(tolerance::largest_lengths, o.target_gap),
               up_to(tolerance::largest_lengths, o.tolerance), o.max_iterations >= 1,
               o.start_contact <= StartContact::ignore, o.detail <= Detail::time_only);
}

/// Whether a body that may turn is seen at a glance to be valid, but for lengths that are not finite.
template <class Shape> static inline bool turns_well(const Shape& s, const Motion& m)
{
    return all(sized(s), valid(m.start.orientation), sum(m.rotation) <= largest_rotation);
}

/// The same of a query, lengths and all, which moreover are near 1.
template <class A, class B> static inline bool usual_turning(const Query& q)
{
    const A& a = as<A>(q.a);
    const B& b = as<B>(q.b);
    const double lengths = size(a) + size(b) + size(q.motion_a) + size(q.motion_b) + q.options.target_gap;
    return all(of_turning_scale(lengths), turns_well(a, q.motion_a), turns_well(b, q.motion_b),
               usual(q.options));
}

} // namespace brink
