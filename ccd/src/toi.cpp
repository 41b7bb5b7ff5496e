// SPDX-License-Identifier: BSD-3-Clause
#include <brink/toi.h>

#include "advance.h"
#include "glance.h"
#include "pairs.h"
#include "tolerance.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace brink {

namespace {

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
    const bool clear = all(lengths<A, B>(q, m) < tolerance::largest_extent, usual(options),
                           translates(as<A>(a), motion_a), translates(as<B>(b), motion_b));
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
    return flipped(solver(b, motion_b, a, motion_a, options)); // NOLINT(readability-suspicious-call-argument)
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
