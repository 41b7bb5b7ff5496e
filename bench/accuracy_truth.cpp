// SPDX-License-Identifier: BSD-3-Clause
#include "accuracy_truth.h"

#include "hull_contact.h"

#include <reference.h>

#include <cmath>
#include <limits>

namespace brink::bench {
namespace {

using support::Real;

constexpr Real grazing_share = 1e-3L; // closing speed over the fastest motion
constexpr Real near_share = 1e-5L;    // separation over the fastest motion: from here on by bisection
constexpr int most_steps = 4000;

/// The rounding of the gap, as support::blur has it, turned into time.
Real doubt(Real scale, Real closing) { return 64 * std::numeric_limits<Real>::epsilon() * scale / closing; }

Truth of_reference(const Body& a, const Body& b)
{
    const support::Query query{a.shape, a.motion, b.shape, b.motion, {}};
    const support::GapOverTime motion(query);
    const support::Reference r = support::reference(query, motion);
    return {r.contact, r.grazing, !r.gave_up, r.t, r.contact ? doubt(motion.scale(), r.closing_speed) : 0};
}

Real closing_speed(const HullsOverTime& hulls, Real t)
{
    constexpr Real step = 1e-7L;
    return (hulls.separation(t) - hulls.separation(t + step)) / step;
}

/// The root of the separation in (apart, apart + ahead], where it is negative at the end.
Real bisected(const HullsOverTime& hulls, Real apart, Real ahead)
{
    Real met = apart + ahead;
    for (;;) {
        const Real middle = (apart + met) / 2;
        if (!(middle > apart && middle < met)) return met;
        (hulls.separation(middle) > 0 ? apart : met) = middle;
    }
}

/// No contact can come sooner than separation over fastest motion: by such steps, until the hulls are so near
/// that the rate tells where they meet. What closes too slowly for that grazes.
Truth of_hulls(const HullsOverTime& hulls)
{
    Real t = 0;
    for (int i = 0; i < most_steps; ++i) {
        const Real apart = hulls.separation(t);
        if (apart <= near_share * hulls.fastest()) {
            const Real closing = closing_speed(hulls, t);
            const Real ahead = 2 * apart / closing;
            if (closing > grazing_share * hulls.fastest() && hulls.separation(t + ahead) < 0) {
                const Real contact = bisected(hulls, t, ahead);
                if (contact > 1) return {};
                const Real slope = closing_speed(hulls, contact);
                return {true, slope < grazing_share * hulls.fastest(), true, contact,
                        doubt(hulls.scale(), slope)};
            }
        }
        t += apart / hulls.fastest();
        if (t > 1) return {};
    }
    return {.known = false};
}

} // namespace

Truth truth(const Body& a, const Body& b)
{
    const auto* hull_a = std::get_if<Hull>(&a.shape);
    const auto* hull_b = std::get_if<Hull>(&b.shape);
    if (hull_a == nullptr || hull_b == nullptr) return of_reference(a, b);
    return of_hulls(HullsOverTime(*hull_a, a.motion, *hull_b, b.motion));
}

} // namespace brink::bench
