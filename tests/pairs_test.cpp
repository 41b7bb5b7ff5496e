// SPDX-License-Identifier: BSD-3-Clause
#include "support/print.h"
#include "support/query.h"
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
