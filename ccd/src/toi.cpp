// SPDX-License-Identifier: BSD-3-Clause
#include <brink/toi.h>

#include "exact_contact.h"
#include "glance.h"
#include "pair_table.h"
#include "pairs.h"
#include "portal_cast.h"
#include "rescale.h"
#include "solve_turning.h"
#include "tolerance.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

namespace brink {

namespace {

[[gnu::always_inline]] inline Approach approach(const Query& q)
{
    const Motion& a = q.motion_a;
    const Motion& b = q.motion_b;
    const V3 from = load(a.start.position) - load(b.start.position);
    return {from, load(a.translation) - load(b.translation), q.options.target_gap, q.options.t_max, a, b};
}

/// A hit with everything a caller may want to know about it.
template <class A, class B> Toi hit(const Query& q, const Approach& m, const Entry& e)
{
    if (q.options.detail == Detail::time_only) return plain(Status::hit, e.t, e.t_upper);
    const double radius_a = radius(as<A>(q.a)), radius_b = radius(as<B>(q.b));
    const Meeting& at = *e.meeting;
    const V3 between = at.core_b - at.core_a;
    double distance = norm(between);
    V3 normal = (1 / distance) * between;
    if (at.flat ||
        !(distance > tolerance::core_noise * (sum_of_magnitudes(m.from) + sum_of_magnitudes(m.by)))) {
        const double length = norm(at.facing);
        if (length > 0)
            normal = (1 / length) * at.facing;
        else if (distance == 0)
            normal = {};
        distance = dot(between, normal); // what the vector between has across the normal is rounding
    }
    const double gap = distance - (radius_a + radius_b);
    const V3 origin = load(q.motion_b.start.position) + e.t * load(q.motion_b.translation);
    const V3 point_a = origin + (at.core_a + radius_a * normal),
             point_b = origin + (at.core_a + (distance - radius_b) * normal);
    return {Status::hit, e.t, e.t_upper, store(normal), store(point_a), store(point_b), gap, 0};
}

template <class A, class B> Toi hit_at(const Query& q, double t, double t_upper)
{
    Toi toi = plain(Status::hit, t, t_upper);
    if (q.options.detail == Detail::contact)
        describe_contact(toi, mover(as<A>(q.a), q.motion_a), mover(as<B>(q.b), q.motion_b), q.options);
    return toi;
}

/// What a closed form left in doubt: for the advancement where there are no exact numbers; else a start that
/// witnesses prove in contact is left to it, and exact numbers tell the rest. What they cannot hold is a hit.
template <class A, class B> [[gnu::noinline]] Toi settle(const Query& q, const Approach& m, const Entry& e)
{
    if constexpr (!in_whole_numbers<A, B>) return solve_turning<A, B>(q);
    const Mover<Core> a = mover(as<A>(q.a), q.motion_a);
    const auto b = mover(as<B>(q.b), q.motion_b);
    if (e.t == 0) {
        if (const std::optional<Toi> toi = from_proven_contact(a, b, q.options)) return *toi;
    }
    const Verdict v = exact_contact(*q.given);
    switch (v.status) {
    case Status::touching:
        return from_contact(a, b, q.options);
    case Status::separated:
        return plain(Status::separated, q.options.t_max);
    case Status::hit:
        if (!e.meeting) return hit_at<A, B>(q, v.t, v.t_upper);
        return hit<A, B>(q, m, {Found::hit, e.t, v.t_upper, e.meeting});
    default:
        return hit_at<A, B>(q, e.t, infinity);
    }
}

template <class A, class B, Entry (*kernel)(const A&, const B&, const Approach&)>
[[gnu::always_inline]] inline Toi solve_translation(const Query& q, const Approach& m)
{
    const Entry e = kernel(as<A>(q.a), as<B>(q.b), m);
    if (e.found == Found::apart) return plain(Status::separated, q.options.t_max);
    if (e.found == Found::hit) return e.meeting ? hit<A, B>(q, m, e) : hit_at<A, B>(q, e.t, e.t_upper);
    return settle<A, B>(q, m, e);
}

/// The answer in the caller's lengths, asked in lengths times 2^exponent.
template <class A, class B, class Solve>
[[gnu::noinline]] Toi rescaled(const Query& q, int exponent, Solve solve)
{
    const Shape a = scaled(as<A>(q.a), exponent), b = scaled(as<B>(q.b), exponent);
    const Motion motion_a = scaled(q.motion_a, exponent), motion_b = scaled(q.motion_b, exponent);
    const Options options = scaled(q.options, exponent);
    return scaled(solve(Query{a, motion_a, b, motion_b, options, &q}), -exponent);
}

template <class A, class B, Entry (*kernel)(const A&, const B&, const Approach&)>
[[gnu::noinline]] Toi solve_with_care(const Query& q)
{
    if (!valid<A, B>(q)) return {};
    const A& a = as<A>(q.a);
    const B& b = as<B>(q.b);
    const Approach m = approach(q);
    const int exponent = exponent_to_usual(a, b, q, m);
    if (exponent == 0) return solve_translation<A, B, kernel>(q, m);
    if (!can_be_scaled(q, exponent)) return settle<A, B>(q, m, {});
    return rescaled<A, B>(q, exponent, [](const Query& near_1) {
        return solve_translation<A, B, kernel>(near_1, approach(near_1));
    });
}

template <class A, class B, Entry (*kernel)(const A&, const B&, const Approach&)>
Toi solve_exactly(const Shape& a, const Motion& motion_a, const Shape& b, const Motion& motion_b,
                  const Options& options)
{
    if (!all(!seen_turning(as<A>(a), motion_a), !seen_turning(as<B>(b), motion_b)))
        return solve<A, B>(a, motion_a, b, motion_b, options);
    const Query q{a, motion_a, b, motion_b, options};
    const Approach m = approach(q);
    const bool clear = all(of_usual_scale(lengths<A, B>(q, m)), usual(options),
                           translates(as<A>(a), motion_a), translates(as<B>(b), motion_b));
    return clear ? solve_translation<A, B, kernel>(q, m) : solve_with_care<A, B, kernel>(q);
}

/// The same for two cores without radius, found by portal refinement; q in their lengths, which are
/// 2^exponent of the caller's.
template <class A, class B> Toi cast_cores(const Core& a, const Core& b, const Query& q, int exponent)
{
    const Approach m = approach(q);
    const Entry e = portal_cast(a, b, m);
    if (e.found == Found::apart) return plain(Status::separated, q.options.t_max);
    if (e.found != Found::hit) return solve_turning<A, B>(*q.given);
    const Toi toi = hit<A, B>(q, m, e);
    return exponent == 0 ? toi : scaled(toi, -exponent);
}

template <class A, class B>
Toi solve_by_casting(const Shape& shape_a, const Motion& motion_a, const Shape& shape_b,
                     const Motion& motion_b, const Options& options)
{
    const A& a = as<A>(shape_a);
    const B& b = as<B>(shape_b);
    if (turns(a, motion_a) || turns(b, motion_b))
        return solve<A, B>(shape_a, motion_a, shape_b, motion_b, options);
    const Query q{shape_a, motion_a, shape_b, motion_b, options};
    if (!valid<A, B>(q)) return {};
    const int e = exponent_to_usual(a, b, q, approach(q));
    if (!can_be_scaled(q, e)) return solve_turning<A, B>(q);
    if (e == 0) return cast_cores<A, B>(part(a), part(b), q, 0);
    const Motion near_a = scaled(motion_a, e), near_b = scaled(motion_b, e);
    const Options near = scaled(options, e);
    return cast_cores<A, B>(scaled(part(a), e), scaled(part(b), e),
                            {shape_a, near_a, shape_b, near_b, near, &q}, e);
}

Toi solve_nothing(const Shape&, const Motion&, const Shape&, const Motion&, const Options&) { return {}; }

template <Solver solver>
Toi swapped(const Shape& a, const Motion& motion_a, const Shape& b, const Motion& motion_b,
            const Options& options)
{
    return flipped(solver(b, motion_b, a, motion_a, options)); // NOLINT(readability-suspicious-call-argument)
}

template <auto kernel> struct Exact;
template <class A, class B, Entry (*kernel)(const A&, const B&, const Approach&)> struct Exact<kernel> {
    static constexpr Method method = in_whole_numbers<A, B> ? Method::closed_form : Method::direct;
    static constexpr Cell<A, B> cell{&solve_exactly<A, B, kernel>, method};
    static constexpr Cell<B, A> flip{&swapped<&solve_exactly<A, B, kernel>>, method};
};

template <auto kernel>
requires(Exact<kernel>::method == Method::closed_form) constexpr auto exact = Exact<kernel>::cell;
template <auto kernel>
requires(Exact<kernel>::method == Method::direct) constexpr auto direct = Exact<kernel>::cell;
template <auto kernel> constexpr auto flip = Exact<kernel>::flip;

template <class S> constexpr bool has_border = std::is_same_v<decltype(part(std::declval<S>())), Border>;

/// Certified advancement is always asked in the table's order, so that swapping the sides changes nothing
/// else; a plane or half-space comes second.
template <class A, class B> constexpr Cell<A, B> advancing()
{
    constexpr bool late = index_of<B> < index_of<A>;
    if constexpr (has_border<A> || (late && !has_border<B>))
        return {&swapped<&solve<B, A>>, Method::advancement};
    else
        return {&solve<A, B>, Method::advancement};
}
template <class A, class B> constexpr auto advance = advancing<A, B>();

/// Likewise in the table's order.
template <class A, class B> constexpr Cell<A, B> casting()
{
    if constexpr (index_of<B> < index_of<A>)
        return {&swapped<&solve_by_casting<B, A>>, Method::direct};
    else
        return {&solve_by_casting<A, B>, Method::direct};
}
template <class A, class B> constexpr auto cast = casting<A, B>();
template <class A, class B> constexpr auto never = Cell<A, B>{&solve_nothing, Method::none};

using S = Sphere;
using C = Capsule;
using X = Box;
using T = Triangle;
using P = Plane;
using H = HalfSpace;
using Y = Cylinder;
using N = Cone;
using E = Ellipsoid;
using U = Hull;

// clang-format off
constexpr std::array table{
    //     Sphere                   Capsule                   Box                Triangle                Plane                 HalfSpace                  Cylinder       Cone           Ellipsoid      Hull
    row<S>(exact<sphere_sphere>,    exact<sphere_capsule>,    exact<sphere_box>, exact<sphere_triangle>, exact<sphere_plane>,  exact<sphere_half_space>,  advance<S, Y>, advance<S, N>, advance<S, E>, advance<S, U>),
    row<C>(flip<sphere_capsule>,    exact<capsule_capsule>,   direct<capsule_box>,    direct<capsule_triangle>,         exact<capsule_plane>, exact<capsule_half_space>, advance<C, Y>, advance<C, N>, advance<C, E>, advance<C, U>),
    row<X>(flip<sphere_box>,        flip<capsule_box>,           direct<box_box>,    cast<X, T>,          exact<box_plane>,        exact<box_half_space>,             advance<X, Y>, advance<X, N>, advance<X, E>, cast<X, U>),
    row<T>(flip<sphere_triangle>,   flip<capsule_triangle>,           cast<T, X>,     cast<T, T>,          exact<triangle_plane>,        exact<triangle_half_space>,             advance<T, Y>, advance<T, N>, advance<T, E>, cast<T, U>),
    row<P>(flip<sphere_plane>,      flip<capsule_plane>,      flip<box_plane>,     flip<triangle_plane>,          never<P, P>,          never<P, H>,               advance<P, Y>, advance<P, N>, advance<P, E>, advance<P, U>),
    row<H>(flip<sphere_half_space>, flip<capsule_half_space>, flip<box_half_space>,     flip<triangle_half_space>,          never<H, P>,          never<H, H>,               advance<H, Y>, advance<H, N>, advance<H, E>, advance<H, U>),
    row<Y>(advance<Y, S>,           advance<Y, C>,            advance<Y, X>,     advance<Y, T>,          advance<Y, P>,        advance<Y, H>,             advance<Y, Y>, advance<Y, N>, advance<Y, E>, advance<Y, U>),
    row<N>(advance<N, S>,           advance<N, C>,            advance<N, X>,     advance<N, T>,          advance<N, P>,        advance<N, H>,             advance<N, Y>, advance<N, N>, advance<N, E>, advance<N, U>),
    row<E>(advance<E, S>,           advance<E, C>,            advance<E, X>,     advance<E, T>,          advance<E, P>,        advance<E, H>,             advance<E, Y>, advance<E, N>, advance<E, E>, advance<E, U>),
    row<U>(advance<U, S>,           advance<U, C>,            cast<U, X>,     cast<U, T>,          advance<U, P>,        advance<U, H>,             advance<U, Y>, advance<U, N>, advance<U, E>, cast<U, U>),
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
