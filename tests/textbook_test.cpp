// SPDX-License-Identifier: BSD-3-Clause
#include "support/moving.h"
#include "support/reference.h"
#include "support/stress.h"
#include "support/textbook.h"

#include <doctest/doctest.h>

using namespace brink;
using namespace brink::support;

TEST_CASE("textbook: two spheres head-on")
{
    // Gap 5 - 1 - 0.5 = 3.5, closing at 7: t = 0.5, exact in binary.
    const Query q{Sphere{1}, moving(Vec3(5, 0, 0), Vec3(-7, 0, 0)), Sphere{0.5}, resting(), {}};
    CHECK(textbook_toi(q, Root::textbook) == 0.5);
    CHECK(textbook_toi(q, Root::stable) == 0.5);
}

TEST_CASE("textbook: on easy cases as the reference says")
{
    int hits = 0;
    int easy = 0;
    for (const Pair& pair : all_pairs()) {
        if (!pair.closed_form()) continue;
        for (std::uint64_t i = 0; i < 2000; ++i) {
            const Query q = stress(pair, Stress::random, 20261122, i).query;
            const GapOverTime motion(q);
            const Reference known = reference(q, motion);
            const Real clear = known.least_gap - static_cast<Real>(q.options.target_gap);
            if (known.contact ? known.grazing || known.t > 0.999 : clear < 1e-9) continue;
            CAPTURE(pair.name());
            CAPTURE(i);
            ++easy;
            for (const Root root : {Root::textbook, Root::stable}) {
                const std::optional<double> t = textbook_toi(q, root);
                REQUIRE(t.has_value() == known.contact);
                if (!t) continue;
                const Real wrong = std::abs(static_cast<Real>(*t) - known.t) * known.closing_speed;
                CHECK(wrong < 1e-12L * motion.scale());
                ++hits;
            }
        }
    }
    CHECK(easy > 15'000);
    CHECK(hits > 15'000);
}
