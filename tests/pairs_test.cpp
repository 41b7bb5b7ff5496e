// SPDX-License-Identifier: BSD-3-Clause
#include "support/query.h"
#include "support/reference.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace brink;
using namespace brink::support;

TEST_CASE("closed forms: t is right to 1e-12 where the approach does not graze, and late by rounding at most")
{
    for (const support::Pair& pair : all_pairs()) {
        if (!pair.closed_form()) continue;
        CAPTURE(pair.name());
        int compared = 0;
        for (std::uint64_t index = 0; index < 4'000; ++index) {
            const Query q = query(pair, Family::translation, 99, index);
            const Toi toi = answer(q);
            if (toi.status != Status::hit) continue;
            const GapOverTime motion(q);
            const Reference truth = reference(q, motion);
            if (!truth.contact || truth.grazing || truth.gave_up) continue;
            CAPTURE(index);
            const Real off = toi.t - truth.t;
            CHECK(std::fabs(off) <= 1e-12L);
            CHECK(off * truth.closing_speed <=
                  2 * 0x1p-52L * motion.scale()); // eps of the lengths that enter
            ++compared;
        }
        CHECK(compared > 1'000);
    }
}
