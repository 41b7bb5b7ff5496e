// SPDX-License-Identifier: BSD-3-Clause
#include "exact_contact.h"

#include "exact_polytope.h"
#include "tolerance.h"

#include <algorithm>
#include <optional>

namespace brink {

namespace {

using exact::Number;
using exact::Path;
using exact::Point;
using exact::Polytope;
using exact::Turn;

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
               256;
    }
};
template <class A, class B>
constexpr Degrees degrees = is_border<B>                ? Degrees{2, is_point<A> ? 4 : 8, 2, 2}
                            : is_point<A>&& is_point<B> ? Degrees{4, 0, 2, 0}
                                                        : Degrees{7, is_point<A> ? 14 : 28, 2, 0};

double radius(const Sphere& s) { return s.radius; }
double radius(const Capsule& s) { return s.radius; }
template <class Shape> double radius(const Shape&) { return 0; }

/// A's origin and motion seen from B, and the sum of the radii, in lengths.
struct Lengths {
    Point from, by;
    Number reach;
};
template <class A, class B> Lengths lengths_of(const A& a, const B& b, const Query& q, int shift)
{
    const auto difference = [&](const Vec3& v, const Vec3& w) {
        return exact::point(v, shift) - exact::point(w, shift);
    };
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

AgainstCore model(const Sphere& a, const Sphere& b, const Query& q, int shift)
{
    const Lengths l = lengths_of(a, b, q, shift);
    return {{l.from, l.by, l.reach * l.reach}, exact::polytope(Point{})};
}

Path path_of(const Lengths& l, const Number& factor)
{
    const Number reach = factor * l.reach;
    return {factor * l.from, factor * l.by, reach * reach};
}

AgainstCore model(const Sphere& a, const Capsule& b, const Query& q, int shift)
{
    const Turn turn(q.motion_b.start.orientation);
    return {path_of(lengths_of(a, b, q, shift), turn.norm_squared),
            exact::polytope(turn * exact::point(b.a, shift), turn * exact::point(b.b, shift))};
}

AgainstCore model(const Sphere& a, const Triangle& b, const Query& q, int shift)
{
    const Turn turn(q.motion_b.start.orientation);
    return {path_of(lengths_of(a, b, q, shift), turn.norm_squared),
            exact::polytope(turn * exact::point(b.a, shift), turn * exact::point(b.b, shift),
                            turn * exact::point(b.c, shift))};
}

/// In the box's axes.
AgainstCore model(const Sphere& a, const Box& b, const Query& q, int shift)
{
    const Turn turn(q.motion_b.start.orientation);
    const Lengths l = lengths_of(a, b, q, shift);
    const Number reach = turn.norm_squared * l.reach;
    return {{turn.into(l.from), turn.into(l.by), reach * reach},
            exact::box(turn.norm_squared * exact::point(b.half_extents, shift))};
}

AgainstCore model(const Capsule& a, const Capsule& b, const Query& q, int shift)
{
    const Turn turn_a(q.motion_a.start.orientation), turn_b(q.motion_b.start.orientation);
    const Point a0 = turn_b.norm_squared * (turn_a * exact::point(a.a, shift)),
                a1 = turn_b.norm_squared * (turn_a * exact::point(a.b, shift));
    const Point b0 = turn_a.norm_squared * (turn_b * exact::point(b.a, shift)),
                b1 = turn_a.norm_squared * (turn_b * exact::point(b.b, shift));
    return {path_of(lengths_of(a, b, q, shift), turn_a.norm_squared * turn_b.norm_squared),
            exact::polytope(b0 - a0, b1 - a0, b1 - a1, b0 - a1)};
}

/// The heights of one or two points over a plane, times a common factor.
struct AgainstBorder {
    Number height[2]; // at t = 0
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
    exact::EntryTimes entry_times() const
    {
        exact::EntryTimes out;
        for (int i = 0; i < points; ++i)
            out.t[out.count++] =
                exact::descent(height[i], reach_squared, height[i].sign() > 0 ? -rate : rate);
        return out;
    }
};

template <class Border>
AgainstBorder against_border(const Border& b, const Query& q, int shift, const Lengths& l, const Turn* turn_a,
                             std::initializer_list<const Vec3*> points)
{
    const Turn turn_b(q.motion_b.start.orientation);
    const Number one(1), &factor_a = turn_a ? turn_a->norm_squared : one;
    const Point normal = turn_b * exact::point(b.normal, 0);
    const Number factor = factor_a * turn_b.norm_squared, reach = factor * l.reach;
    const Number base = factor_a * dot(normal, l.from) - factor * Number(b.offset, shift);
    AgainstBorder out;
    out.points = 0;
    for (const Vec3* p : points)
        out.height[out.points++] = p ? base + dot(normal, *turn_a * exact::point(*p, shift)) : base;
    out.rate = factor_a * dot(normal, l.by);
    const Point n = exact::point(b.normal, 0);
    out.reach_squared = reach * reach * dot(n, n);
    out.solid = std::is_same_v<Border, HalfSpace>;
    return out;
}

template <class Border>
AgainstBorder model_border(const Sphere& a, const Border& b, const Query& q, int shift)
{
    return against_border(b, q, shift, lengths_of(a, b, q, shift), nullptr, {nullptr});
}
template <class Border>
AgainstBorder model_border(const Capsule& a, const Border& b, const Query& q, int shift)
{
    const Turn turn(q.motion_a.start.orientation);
    return against_border(b, q, shift, lengths_of(a, b, q, shift), &turn, {&a.a, &a.b});
}
AgainstBorder model(const Sphere& a, const Plane& b, const Query& q, int s)
{
    return model_border(a, b, q, s);
}
AgainstBorder model(const Sphere& a, const HalfSpace& b, const Query& q, int s)
{
    return model_border(a, b, q, s);
}
AgainstBorder model(const Capsule& a, const Plane& b, const Query& q, int s)
{
    return model_border(a, b, q, s);
}
AgainstBorder model(const Capsule& a, const HalfSpace& b, const Query& q, int s)
{
    return model_border(a, b, q, s);
}

/// A model's question with its numbers' sizes looked at.
template <class Model> struct Asked {
    const Model& model;
    const Spans& spans;
    Degrees degrees;

    /// Whether there is contact by t; empty where the numbers do not fit.
    std::optional<bool> meets(double t) const
    {
        Span at = spans.time;
        at.add(t);
        if (!degrees.fit(spans, at)) return {};
        return model.meets(t);
    }
    bool certainly(bool contact, double t) const { return meets(t) == contact; }
};

/// The bracket about the first of the sorted times by which there is contact. Steps outwards from where it
/// should be until both ends are proven.
template <class Model> Verdict bracket(const Asked<Model>& asked, exact::EntryTimes times, double t_max)
{
    std::sort(times.t, times.t + times.count);
    const auto upwards = [&](double t) { return std::min(t + t * tolerance::exact_root, t_max); };
    const auto reached = [&](double t) { return asked.certainly(true, upwards(t)); };
    const double* first =
        std::partition_point(times.t, times.t + times.count, [&](double t) { return !reached(t); });
    const double found = first == times.t + times.count ? t_max : *first;
    Verdict out{Status::hit, 0, upwards(found)};
    for (double down = tolerance::exact_root; down < 1; down *= 16) {
        const double t = found - found * down;
        if (!asked.certainly(false, t)) continue;
        out.t = t;
        break;
    }
    return out;
}

template <class A, class B> Verdict verdict(const Query& q)
{
    const double t_max = q.options.t_max;
    const A& a = *std::get_if<A>(&q.a);
    const B& b = *std::get_if<B>(&q.b);
    const Spans spans = spans_of(a, b, q);
    if (!degrees<A, B>.fit(spans, spans.time)) return {};
    const auto world = model(a, b, q, spans.length.shift());
    const Asked<std::decay_t<decltype(world)>> asked{world, spans, degrees<A, B>};
    if (world.meets(0)) return {Status::touching, 0, 0};
    const std::optional<bool> met = asked.meets(t_max);
    if (!met) return {};
    if (!*met) return {Status::separated, t_max, infinity};
    return bracket(asked, world.entry_times(), t_max);
}

template <class A, class B> bool are(const Query& q)
{
    return std::holds_alternative<A>(q.a) && std::holds_alternative<B>(q.b);
}

} // namespace

Verdict exact_contact(const Query& q)
{
    if (are<Sphere, Sphere>(q)) return verdict<Sphere, Sphere>(q);
    if (are<Sphere, Capsule>(q)) return verdict<Sphere, Capsule>(q);
    if (are<Sphere, Box>(q)) return verdict<Sphere, Box>(q);
    if (are<Sphere, Triangle>(q)) return verdict<Sphere, Triangle>(q);
    if (are<Sphere, Plane>(q)) return verdict<Sphere, Plane>(q);
    if (are<Sphere, HalfSpace>(q)) return verdict<Sphere, HalfSpace>(q);
    if (are<Capsule, Capsule>(q)) return verdict<Capsule, Capsule>(q);
    if (are<Capsule, Plane>(q)) return verdict<Capsule, Plane>(q);
    return verdict<Capsule, HalfSpace>(q);
}

} // namespace brink
