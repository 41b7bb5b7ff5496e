// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "advance.h"
#include "support/print.h"
#include "support/query.h"
#include "support/verdict.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

/// Closed forms of polytopes under translation, held against certified advancement, which finds the same by
/// other means, and against the reference in long double.
namespace brink::tests {

/// What a sample turned out to hold.
struct Held {
    int hits = 0, separated = 0, touching = 0;
    int close = 0;    // misses by less than 1e-3 and hits as shallow
    int advanced = 0; // left to advancement
    int unproven = 0; // hits without t_upper
};

inline Toi advancement(const support::Query& q)
{
    const auto solve = [&](const auto& a, const auto& b) -> Toi {
        using A = std::decay_t<decltype(a)>;
        using B = std::decay_t<decltype(b)>;
        constexpr bool bounded = !std::is_same_v<A, Plane> && !std::is_same_v<A, HalfSpace>;
        if constexpr (bounded && (!std::is_same_v<B, Plane> || !std::is_same_v<B, HalfSpace>))
            return certified_advancement(mover(a, q.motion_a), mover(b, q.motion_b), q.options,
                                         {{q.a, q.motion_a, q.b, q.motion_b, q.options}});
        return {};
    };
    return std::visit(solve, q.a, q.b);
}

/// What contradicts: both never late, both `separated` only when proven.
inline const char* contradiction(const support::Query& q, const Toi& toi, const Toi& other,
                                 const support::GapOverTime& motion)
{
    const support::Real rounding = 16 * 0x1p-52L * motion.scale(), target = q.options.target_gap;
    const bool proven = toi.status == Status::hit && toi.t_upper < infinity;
    if (proven && other.status == Status::separated) return "proven contact, yet separated by advancement";
    if (proven && other.status == Status::hit && other.t > toi.t_upper) return "t_upper too early";
    if (toi.status == Status::touching && other.status == Status::separated &&
        !(motion.at(0).gap <= target + rounding))
        return "touching, yet separated";
    if (toi.status == Status::separated && other.status == Status::hit &&
        !(motion.at(other.t).gap >= target - rounding))
        return "missed a hit";
    if (toi.status != Status::hit || toi.iterations > 0 || toi.t == 0) return nullptr;
    const support::Real gap = motion.at(toi.t).gap, before = motion.at(toi.t * 0.999L).gap;
    const support::Real last_bit = 0x1p-52L * motion.fastest() * toi.t;
    if (gap < target - rounding - last_bit) return "late: deep at t";
    if (before < gap - rounding - last_bit) return "late: parting at t";
    if (gap > target + rounding + last_bit) return "early";
    return nullptr;
}

/// Asks `count` queries of a pair that only translate; every `share`th is judged by the reference too.
inline Held hold_against_advancement(const support::Pair& pair, std::uint64_t seed, std::uint64_t count,
                                     std::uint64_t share)
{
    Held held;
    for (std::uint64_t index = 0; index < count; ++index) {
        const support::Query q = support::query(pair, support::Family::translation, seed, index);
        support::Trial trial(q);
        const Toi& toi = trial.toi();
        held.hits += toi.status == Status::hit ? 1 : 0;
        held.separated += toi.status == Status::separated ? 1 : 0;
        held.touching += toi.status == Status::touching ? 1 : 0;
        held.advanced += toi.iterations > 0 ? 1 : 0;
        held.unproven += toi.status == Status::hit && toi.t_upper == infinity ? 1 : 0;
        if (q.options.start_contact == StartContact::report) {
            const char* wrong = contradiction(q, toi, advancement(q), trial.motion());
            CAPTURE(index);
            if (wrong) FAIL_CHECK(std::string(wrong), "\n", support::as_cpp(q, support::in_words(toi)));
        }
        if (index % share != 0) continue;
        for (const support::Finding& finding : judge(trial))
            FAIL_CHECK(finding.check, ": ", finding.detail, "\n", support::as_cpp(q, support::in_words(toi)));
        const support::Real depth = std::fabs(trial.referee().least_gap - q.options.target_gap);
        held.close += depth > 0 && depth < 1e-3L ? 1 : 0;
    }
    return held;
}

} // namespace brink::tests
