// SPDX-License-Identifier: BSD-3-Clause
#include "support/print.h"
#include "support/query.h"
#include "support/random.h"
#include "support/reference.h"

#if BRINK_HAVE_REFEREE
#include "support/referee.h"
#include "support/stress.h"
#endif

#include <doctest/doctest.h>

#include <cmath>

using namespace brink;
using namespace brink::support;

TEST_CASE(
    "closed forms: t is right to 1e-12 where the approach does not graze, and contact is proven by t_upper")
{
    for (const support::Pair& pair : all_pairs()) {
        if (!pair.closed_form()) continue;
        CAPTURE(pair.name());
        int compared = 0;
        for (std::uint64_t index = 0; index < 4'000; ++index) {
            const Query q = query(pair, Family::translation, 99, index);
            const Toi toi = answer(q);
            if (toi.status != Status::hit) continue;
            CAPTURE(index);
            CHECK(toi.t_upper <= q.options.t_max);
            const GapOverTime motion(q);
            const Reference truth = reference(q, motion);
            if (!truth.contact || truth.grazing || truth.gave_up) continue;
            CHECK(std::fabs(toi.t - truth.t) <= 1e-12L);
            ++compared;
        }
        CHECK(compared > 1'000);
    }
}

#if BRINK_HAVE_REFEREE
namespace {

/// Two capsules that meet or nearly do, drawn far from their bodies' origins: rounding is that of turning
/// them.
Query far_from_origins(Random& random)
{
    Query q;
    for (const bool first : {true, false}) {
        const double off = random.log_between(1e2, 1e8);
        const Vec3 middle = off * random.unit(), half = 0.5 * random.unit();
        const double radius = random.between(0.01, 1);
        Motion& motion = first ? q.motion_a : q.motion_b;
        motion.start.orientation = random.rotation();
        const Vec3 turned = rounded(rotation_matrix(motion.start.orientation) * real3(middle));
        motion.start.position = -turned;
        (first ? q.a : q.b) = Capsule{middle - half, middle + half, radius};
    }
    const Vec3 away = random.between(2, 4) * random.unit(), past = random.in_cube(1.5);
    q.motion_a.start.position += away;
    q.motion_a.translation = past - 2 * away;
    return q;
}

} // namespace

TEST_CASE("closed forms: capsules far from their bodies' origins, in 200 digits")
{
    Random random(20261123);
    int hits = 0;
    for (int index = 0; index < 1'500; ++index) {
        Query q = far_from_origins(random);
        if (index % 3 == 0) q.b = Plane{random.unit(), 0};
        const Toi toi = answer(q);
        for (const Finding& finding : verify(q, toi)) {
            CAPTURE(index);
            FAIL_CHECK(finding.check, ": ", finding.detail, "\n", as_cpp(q, in_words(toi)));
        }
        hits += toi.status == Status::hit ? 1 : 0;
    }
    CHECK(hits > 500);
}

TEST_CASE("closed forms: every promise kept in every class of difficulty, in 200 digits")
{
    for (const support::Pair& pair : all_pairs()) {
        if (!pair.closed_form()) continue;
        const int cases = pair.name() == "sphere-sphere" ? 1'500 : 150;
        for (const StressClass& kind : stress_classes) {
            CAPTURE(pair.name());
            CAPTURE(std::string(kind.name));
            int hits = 0, conservative = 0;
            for (int index = 0; index < cases; ++index) {
                const Query q = stress(pair, kind.stress, 20261122, static_cast<std::uint64_t>(index)).query;
                const Toi toi = answer(q);
                for (const Finding& finding : verify(q, toi)) {
                    CAPTURE(index);
                    FAIL_CHECK(finding.check, ": ", finding.detail, "\n", as_cpp(q, in_words(toi)));
                }
                hits += toi.status == Status::hit || toi.status == Status::touching ? 1 : 0;
                conservative += toi.status == Status::hit && toi.t_upper == infinity ? 1 : 0;
            }
            CHECK(conservative == 0);
            CHECK(hits > cases / 5);
        }
    }
}
#endif
