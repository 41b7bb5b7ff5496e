// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "border_entry.h"
#include "exact_polytope.h"
#include "glance.h"

#include <optional>
#include <type_traits>

/// A pair of translating shapes in exact numbers.
namespace brink::exact {

/// How many limbs the doubles of each dimension reach over.
struct Spans {
    Span length, rotation, time, normal;

    Spans()
    {
        time.add(1); // beside powers of the time
        normal.add(1);
    }
    void add(const Vec3& v)
    {
        for (int i = 0; i < 3; ++i)
            length.add(v.data()[i]);
    }
    void add(const Quat& q)
    {
        for (int i = 0; i < 4; ++i)
            rotation.add(q.coeffs().data()[i]);
    }
    void add(const Sphere& s) { length.add(s.radius); }
    void add(const Capsule& s)
    {
        add(s.a);
        add(s.b);
        length.add(s.radius);
    }
    void add(const Box& s) { add(s.half_extents); }
    void add(const Triangle& s)
    {
        add(s.a);
        add(s.b);
        add(s.c);
    }
    template <class Border> void add(const Border& s)
    {
        for (int i = 0; i < 3; ++i)
            normal.add(s.normal.data()[i]);
        length.add(s.offset);
    }
};

template <class Shape>
constexpr bool is_border = std::is_same_v<Shape, Plane> || std::is_same_v<Shape, HalfSpace>;
template <class Shape> constexpr bool is_point = std::is_same_v<Shape, Sphere>;

template <class A, class B> Spans spans_of(const A& a, const B& b, const Query& q)
{
    Spans out;
    out.add(a);
    out.add(b);
    out.length.add(q.options.target_gap);
    for (const Motion* m : {&q.motion_a, &q.motion_b}) {
        out.add(m->start.position);
        out.add(m->translation);
    }
    if (!is_point<A>) out.add(q.motion_a.start.orientation);
    if (!is_point<B>) out.add(q.motion_b.start.orientation);
    return out;
}

/// Whether every number that the pair's questions multiply together fits: their degrees in lengths,
/// quaternion components, times and normals, counted in numerics.md.
struct Degrees {
    int length, rotation, time, normal;
    bool fit(const Spans& s, Span at) const
    {
        return length * s.length.limbs() + rotation * s.rotation.limbs() + time * at.limbs() +
                   normal * s.normal.limbs() + 2 <=
               capacity;
    }
};
template <class A, class B>
constexpr Degrees degrees = is_border<B>                ? Degrees{2, is_point<A> ? 4 : 8, 2, 2}
                            : is_point<A>&& is_point<B> ? Degrees{4, 0, 2, 0}
                                                        : Degrees{7, is_point<A> ? 14 : 28, 2, 0};

/// A's origin and motion seen from B, and the sum of the radii, in lengths.
struct Lengths {
    Point from, by;
    Number reach;
};
template <class A, class B> Lengths lengths_of(const A& a, const B& b, const Query& q, int shift)
{
    const auto difference = [&](const Vec3& v, const Vec3& w) { return point(v, shift) - point(w, shift); };
    return {difference(q.motion_a.start.position, q.motion_b.start.position),
            difference(q.motion_a.translation, q.motion_b.translation),
            Number(radius(a), shift) + Number(radius(b), shift) + Number(q.options.target_gap, shift)};
}

/// A point among the corners of B's core minus A's. `t` is exact.
struct AgainstCore {
    Path path;
    Polytope core;

    bool meets(double t) const { return exact::meets(core, path, Number(t)); }
    exact::EntryTimes entry_times() const { return exact::entry_times(core, path); }
};

static inline AgainstCore model(const Sphere& a, const Sphere& b, const Query& q, int shift)
{
    const Lengths l = lengths_of(a, b, q, shift);
    return {{l.from, l.by, l.reach * l.reach}, polytope(Point{})};
}

static inline Path path_of(const Lengths& l, const Number& factor)
{
    const Number reach = factor * l.reach;
    return {factor * l.from, factor * l.by, reach * reach};
}

static inline AgainstCore model(const Sphere& a, const Capsule& b, const Query& q, int shift)
{
    const Turn turn(q.motion_b.start.orientation);
    return {path_of(lengths_of(a, b, q, shift), turn.norm_squared),
            polytope(turn * point(b.a, shift), turn * point(b.b, shift))};
}

static inline AgainstCore model(const Sphere& a, const Triangle& b, const Query& q, int shift)
{
    const Turn turn(q.motion_b.start.orientation);
    return {path_of(lengths_of(a, b, q, shift), turn.norm_squared),
            polytope(turn * point(b.a, shift), turn * point(b.b, shift), turn * point(b.c, shift))};
}

/// In the box's axes.
static inline AgainstCore model(const Sphere& a, const Box& b, const Query& q, int shift)
{
    const Turn turn(q.motion_b.start.orientation);
    const Lengths l = lengths_of(a, b, q, shift);
    const Number reach = turn.norm_squared * l.reach;
    return {{turn.into(l.from), turn.into(l.by), reach * reach},
            box(turn.norm_squared * point(b.half_extents, shift))};
}

static inline AgainstCore model(const Capsule& a, const Capsule& b, const Query& q, int shift)
{
    const Turn turn_a(q.motion_a.start.orientation), turn_b(q.motion_b.start.orientation);
    const Point a0 = turn_b.norm_squared * (turn_a * point(a.a, shift)),
                a1 = turn_b.norm_squared * (turn_a * point(a.b, shift));
    const Point b0 = turn_a.norm_squared * (turn_b * point(b.a, shift)),
                b1 = turn_a.norm_squared * (turn_b * point(b.b, shift));
    return {path_of(lengths_of(a, b, q, shift), turn_a.norm_squared * turn_b.norm_squared),
            polytope(b0 - a0, b1 - a0, b1 - a1, b0 - a1)};
}

/// The heights of a core's corners over a plane, times a common factor.
struct AgainstBorder {
    Number height[8]; // at t = 0
    int points;
    Number rate;
    Number reach_squared;
    bool solid;

    /// Whether a height lies above (side 1) or below (side -1) the band of the reach.
    bool beyond(const Number& h, int side) const
    {
        return h.sign() * side > 0 && (h * h - reach_squared).sign() > 0;
    }
    bool all_beyond(const Number& moved, int side) const
    {
        for (int i = 0; i < points; ++i)
            if (!beyond(height[i] + moved, side)) return false;
        return true;
    }
    bool apart(const Number& moved, int side) const
    {
        return all_beyond(Number(), side) && all_beyond(moved, side);
    }
    bool meets(double t) const
    {
        const Number moved = Number(t) * rate;
        return !(apart(moved, 1) || (!solid && apart(moved, -1)));
    }
    EntryTimes entry_times() const
    {
        EntryTimes out;
        for (int i = 0; i < points; ++i)
            out.t[out.count++] = descent(height[i], reach_squared, height[i].sign() > 0 ? -rate : rate);
        return out;
    }
};

template <class A, class Border>
AgainstBorder against_border(const A& a, const Border& b, const Query& q, int shift)
{
    const Lengths l = lengths_of(a, b, q, shift);
    const Turn turn_b(q.motion_b.start.orientation);
    std::optional<Turn> turn_a;
    if (!is_point<A>) turn_a.emplace(q.motion_a.start.orientation);
    const Number one(1), &factor_a = turn_a ? turn_a->norm_squared : one;
    const Point normal = turn_b * point(b.normal, 0);
    const Number factor = factor_a * turn_b.norm_squared, reach = factor * l.reach;
    const Number base = factor_a * dot(normal, l.from) - factor * Number(b.offset, shift);
    AgainstBorder out;
    out.points = above_border::ends<A>;
    for (int i = 0; i < out.points; ++i)
        out.height[i] =
            turn_a ? base + dot(normal, *turn_a * point(store(above_border::end(a, i)), shift)) : base;
    out.rate = factor_a * dot(normal, l.by);
    const Point n = point(b.normal, 0);
    out.reach_squared = reach * reach * dot(n, n);
    out.solid = std::is_same_v<Border, HalfSpace>;
    return out;
}

template <class A> AgainstBorder model(const A& a, const Plane& b, const Query& q, int shift)
{
    return against_border(a, b, q, shift);
}
template <class A> AgainstBorder model(const A& a, const HalfSpace& b, const Query& q, int shift)
{
    return against_border(a, b, q, shift);
}

} // namespace brink::exact
