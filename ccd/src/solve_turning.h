// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "advance.h"
#include "exact_contact.h"
#include "glance.h"
#include "point_path.h"
#include "rescale.h"
#include "start_contact.h"
#include "toi_query.h"
#include "tolerance.h"
#include "window.h"

/// Pairs of which a body turns, or that no closed form translates.
namespace brink {

/// Of a pair whose first contact exact numbers tell, too. What even those cannot hold counts as contact.
static inline std::optional<bool> begins_in_contact(const Query& q)
{
    const Motion a = Motion::still(q.motion_a.start), b = Motion::still(q.motion_b.start);
    Options at_start = q.options;
    at_start.t_max = 0;
    return exact_contact({q.a, a, q.b, b, at_start}).status != Status::separated;
}

/// A sphere's way past a shape, in lengths times 2^e, where that is short; else invalid.
template <class A, class B> static Toi pass(const Query& q, int e)
{
    if constexpr (std::is_same_v<A, Sphere> && has_closed_distance<B>) {
        const A& a = as<A>(q.a);
        const B& b = as<B>(q.b);
        if (turns(a, q.motion_a) || q.options.max_iterations <= tolerance::most_passing) return {};
        if (e == 0) return pass(a, q.motion_a, b, q.motion_b, q.options);
        return scaled(pass(scaled(a, e), scaled(q.motion_a, e), scaled(b, e), scaled(q.motion_b, e),
                           scaled(q.options, e)),
                      -e);
    }
    return {};
}

/// By advancement, in lengths times 2^e.
template <class A, class B> static Toi solve_turning(const Query& q, int e)
{
    Toi passed = pass<A, B>(q, e);
    if (passed.status != Status::invalid) return passed;
    const A& a = as<A>(q.a);
    const B& b = as<B>(q.b);
    const StartOracle oracle{*q.given, in_whole_numbers<A, B> ? &begins_in_contact : &in_contact_at_start};
    const int spent = passed.iterations;
    if (e != 0) {
        const auto near_a = mover(scaled(part(a), e), scaled(q.motion_a, e));
        const auto near_b = mover(scaled(part(b), e), scaled(q.motion_b, e));
        return scaled(certified_advancement(near_a, near_b, scaled(q.options, e), oracle, spent), -e);
    }
    if constexpr (std::is_same_v<decltype(part(b)), Core>)
        if (never_near(held(a) + held(b), q.motion_a, q.motion_b, q.options))
            return plain(Status::separated, q.options.t_max);
    return certified_advancement(mover(a, q.motion_a), mover(b, q.motion_b), q.options, oracle, spent);
}
template <class A, class B> static Toi solve_turning(const Query& q)
{
    return solve_turning<A, B>(q, exponent_to_usual(as<A>(q.a), as<B>(q.b), q));
}

template <class A, class B>
[[gnu::noinline]] static Toi solve(const Shape& a, const Motion& motion_a, const Shape& b,
                                   const Motion& motion_b, const Options& options)
{
    const Query q{a, motion_a, b, motion_b, options};
    if (usual_turning<A, B>(q)) return solve_turning<A, B>(q, 0);
    return valid<A, B>(q) ? solve_turning<A, B>(q) : Toi{};
}

} // namespace brink
