// SPDX-License-Identifier: BSD-3-Clause
#include <brink/toi.h>

#include "advance.h"
#include "pairs.h"
#include "toi_query.h"
#include "tolerance.h"
#include "valid_motion.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace brink {

namespace {

/// The shape that the table's row or column says it is.
template <class Shape> const Shape& as(const brink::Shape& shape)
{
    const Shape* s = std::get_if<Shape>(&shape);
    if (!s) __builtin_unreachable();
    return *s;
}

bool valid(const Options& o)
{
    return o.t_max >= 0 && o.t_max <= 1 && is_size(o.target_gap) && is_size(o.tolerance) &&
           o.max_iterations >= 1 && o.start_contact <= StartContact::ignore && o.detail <= Detail::time_only;
}

template <class A, class B> bool valid(const Query& q)
{
    return valid(q.options) && valid(as<A>(q.a), q.motion_a) && valid(as<B>(q.b), q.motion_b);
}

double radius(const Sphere& s) { return s.radius; }
double radius(const Capsule& s) { return s.radius; }
template <class Shape> double radius(const Shape&) { return 0; }

double sum(const Vec3& v) { return sum_of_magnitudes(load(v)); }
double size(const Sphere& s) { return s.radius; }
double size(const Capsule& s) { return sum(s.a) + sum(s.b) + s.radius; }
double size(const Box& s) { return sum(s.half_extents); }
double size(const Triangle& s) { return sum(s.a) + sum(s.b) + sum(s.c); }
double size(const Plane& s) { return std::fabs(s.offset); }
double size(const HalfSpace& s) { return std::fabs(s.offset); }

/// The lengths of a valid query, added up. Products of four stay far from overflow below `largest_extent`; a
/// sum that is not says nothing about which one is to blame, or that one is not finite.
template <class A, class B> double lengths(const Query& q, const Approach& m)
{
    return sum_of_magnitudes(m.from) + sum_of_magnitudes(m.by) + sum(q.motion_a.pivot) +
           sum(q.motion_b.pivot) + size(as<A>(q.a)) + size(as<B>(q.b)) + m.target_gap;
}

/// Not negative (nor -0), not NaN and at most `most`: one comparison, because such doubles sort like their
/// bits.
bool up_to(double most, double x)
{
    return std::bit_cast<std::uint64_t>(x) <= std::bit_cast<std::uint64_t>(most);
}
/// Nonzero in some bit but the sign.
std::uint64_t any_bit(const Vec3& v)
{
    const double* c = v.data();
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
    return (bits(c[0]) | bits(c[1]) | bits(c[2])) << 1U;
}

/// What a shape's own check asks besides finite lengths.
bool sized(const Sphere& s) { return up_to(tolerance::largest_extent, s.radius); }
bool sized(const Capsule& s) { return up_to(tolerance::largest_extent, s.radius); }
bool sized(const Triangle&) { return true; }
bool sized(const Box& s)
{
    constexpr double most = tolerance::largest_extent;
    return up_to(most, s.half_extents.x()) & up_to(most, s.half_extents.y()) &
           up_to(most, s.half_extents.z());
}
template <class Shape> bool sized(const Shape& s) { return brink::valid(s); }

/// Whether a body is seen at a glance to translate only, and to be valid but for lengths that are not finite.
template <class Shape> [[gnu::always_inline]] inline bool translates(const Shape& s, const Motion& m)
{
    if constexpr (std::is_same_v<Shape, Sphere>)
        return sized(s) & (any_bit(m.pivot) == 0) & (sum(m.rotation) <= largest_rotation);
    else
        return sized(s) & brink::valid(m.start.orientation) & (any_bit(m.rotation) == 0);
}
bool usual(const Options& o)
{
    return up_to(1, o.t_max) & up_to(tolerance::largest_extent, o.target_gap) &
           up_to(tolerance::largest_extent, o.tolerance) & (o.max_iterations >= 1) &
           (o.start_contact <= StartContact::ignore) & (o.detail <= Detail::time_only);
}

[[gnu::always_inline]] inline Approach approach(const Query& q)
{
    const Pose& a = q.motion_a.start;
    const Pose& b = q.motion_b.start;
    const V3 by = load(q.motion_a.translation) - load(q.motion_b.translation);
    return {load(a.position) - load(b.position), by, q.options.target_gap, a, b};
}

/// An answer that has a time but no contact to tell about.
Toi plain(Status status, double t)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {status, t, infinity, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, nan, 0};
}

/// A hit with everything a caller may want to know about it.
Toi hit(const Query& q, const Approach& m, const Entry& e, double radius_a, double radius_b)
{
    if (q.options.detail == Detail::time_only) return plain(Status::hit, e.t);
    const V3 between = e.core_b - e.core_a;
    const double distance = norm(between), gap = distance - (radius_a + radius_b);
    V3 normal = (1 / distance) * between;
    if (e.flat ||
        !(distance > tolerance::core_noise * (sum_of_magnitudes(m.from) + sum_of_magnitudes(m.by)))) {
        const double length = norm(e.facing);
        if (length > 0)
            normal = (1 / length) * e.facing;
        else if (distance == 0)
            normal = {};
    }
    const V3 origin = load(q.motion_b.start.position) + e.t * load(q.motion_b.translation);
    const V3 point_a = origin + (e.core_a + radius_a * normal),
             point_b = origin + (e.core_b - radius_b * normal);
    return {Status::hit, e.t, infinity, store(normal), store(point_a), store(point_b), gap, 0};
}

template <class A, class B> [[gnu::noinline]] Toi solve_by_advancing(const Query& q, Start start)
{
    return certified_advancement(mover(as<A>(q.a), q.motion_a), mover(as<B>(q.b), q.motion_b), q.options,
                                 start);
}

template <class A, class B, Entry (*kernel)(const A&, const B&, const Approach&)>
[[gnu::always_inline]] inline Toi solve_translation(const Query& q, const Approach& m)
{
    const Entry e = kernel(as<A>(q.a), as<B>(q.b), m);
    if (e.t == 0) return solve_by_advancing<A, B>(q, Start::in_contact);
    if (!(e.t <= q.options.t_max)) return plain(Status::separated, q.options.t_max);
    return hit(q, m, e, radius(as<A>(q.a)), radius(as<B>(q.b)));
}

template <class A, class B, Entry (*kernel)(const A&, const B&, const Approach&)>
[[gnu::noinline]] Toi solve_with_care(const Query& q)
{
    if (!valid<A, B>(q)) return {};
    const Approach m = approach(q);
    if (!(lengths<A, B>(q, m) < tolerance::largest_extent)) return plain(Status::undecided, 0);
    if (turns(as<A>(q.a), q.motion_a) || turns(as<B>(q.b), q.motion_b))
        return solve_by_advancing<A, B>(q, Start::open);
    return solve_translation<A, B, kernel>(q, m);
}

template <class A, class B, Entry (*kernel)(const A&, const B&, const Approach&)>
Toi solve_exactly(const Shape& a, const Motion& motion_a, const Shape& b, const Motion& motion_b,
                  const Options& options)
{
    const Query q{a, motion_a, b, motion_b, options};
    const Approach m = approach(q);
    const bool clear = (lengths<A, B>(q, m) < tolerance::largest_extent) & usual(options) &
                       translates(as<A>(a), motion_a) & translates(as<B>(b), motion_b);
    return clear ? solve_translation<A, B, kernel>(q, m) : solve_with_care<A, B, kernel>(q);
}

template <class A, class B>
Toi solve(const Shape& a, const Motion& motion_a, const Shape& b, const Motion& motion_b,
          const Options& options)
{
    const Query q{a, motion_a, b, motion_b, options};
    if (!valid<A, B>(q)) return {};
    if (!(lengths<A, B>(q, approach(q)) < tolerance::largest_extent)) return plain(Status::undecided, 0);
    return solve_by_advancing<A, B>(q, Start::open);
}

Toi solve_nothing(const Shape&, const Motion&, const Shape&, const Motion&, const Options&) { return {}; }

/// Answers like time_of_impact, for one pair of shapes.
using Solver = decltype(&time_of_impact);

template <Solver solver>
Toi swapped(const Shape& a, const Motion& motion_a, const Shape& b, const Motion& motion_b,
            const Options& options)
{
    return flipped(solver(b, motion_b, a, motion_a, options));
}

/// One pair of the table. The types keep every solver in its row and column.
template <class A, class B> struct Cell {
    Solver solve;
    Method method;
};

template <auto kernel> struct Exact;
template <class A, class B, Entry (*kernel)(const A&, const B&, const Approach&)> struct Exact<kernel> {
    static constexpr Cell<A, B> cell{&solve_exactly<A, B, kernel>, Method::closed_form};
    static constexpr Cell<B, A> flip{&swapped<&solve_exactly<A, B, kernel>>, Method::closed_form};
};

template <auto kernel> constexpr auto exact = Exact<kernel>::cell;
template <auto kernel> constexpr auto flip = Exact<kernel>::flip;

template <class T, class... Ts> constexpr std::size_t index_in(const std::variant<Ts...>*)
{
    const bool same[] = {std::is_same_v<T, Ts>...};
    std::size_t i = 0;
    while (!same[i])
        ++i;
    return i;
}
template <class T> constexpr std::size_t index_of = index_in<T>(static_cast<const Shape*>(nullptr));

/// Certified advancement is always asked in the table's order, so that swapping the sides changes nothing
/// else.
template <class A, class B> constexpr Cell<A, B> advancing()
{
    if constexpr (index_of < A >> index_of<B>)
        return {&swapped<&solve<B, A>>, Method::advancement};
    else
        return {&solve<A, B>, Method::advancement};
}
template <class A, class B> constexpr auto advance = advancing<A, B>();
template <class A, class B> constexpr auto never = Cell<A, B>{&solve_nothing, Method::none};

template <class A, class... B> constexpr std::array<Cell<void, void>, sizeof...(B)> row(Cell<A, B>... cells)
{
    static_assert(std::is_same_v<std::variant<B...>, Shape>, "a row has one cell for each shape, in order");
    return {Cell<void, void>{cells.solve, cells.method}...};
}

using S = Sphere;
using C = Capsule;
using X = Box;
using T = Triangle;
using P = Plane;
using H = HalfSpace;

// clang-format off
constexpr std::array table{
    //     Sphere                   Capsule                    Box                 Triangle               Plane                  HalfSpace
    row<S>(exact<sphere_sphere>,    exact<sphere_capsule>,     exact<sphere_box>,  exact<sphere_triangle>, exact<sphere_plane>,  exact<sphere_half_space>),
    row<C>(flip<sphere_capsule>,    exact<capsule_capsule>,    advance<C, X>,      advance<C, T>,          exact<capsule_plane>, exact<capsule_half_space>),
    row<X>(flip<sphere_box>,        advance<X, C>,             advance<X, X>,      advance<X, T>,          advance<X, P>,        advance<X, H>),
    row<T>(flip<sphere_triangle>,   advance<T, C>,             advance<T, X>,      advance<T, T>,          advance<T, P>,        advance<T, H>),
    row<P>(flip<sphere_plane>,      flip<capsule_plane>,       advance<P, X>,      advance<P, T>,          never<P, P>,          never<P, H>),
    row<H>(flip<sphere_half_space>, flip<capsule_half_space>,  advance<H, X>,      advance<H, T>,          never<H, P>,          never<H, H>),
};
// clang-format on
static_assert(table.size() == std::variant_size_v<Shape>);

} // namespace

Method method(const Shape& a, const Shape& b) { return table[a.index()][b.index()].method; }

Toi time_of_impact(const Shape& a, const Motion& motion_a, const Shape& b, const Motion& motion_b,
                   const Options& options)
{
    if (std::max(a.index(), b.index()) >= table.size()) return {}; // lost its value to an exception
    return table[a.index()][b.index()].solve(a, motion_a, b, motion_b, options);
}

} // namespace brink
