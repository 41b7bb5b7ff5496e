// SPDX-License-Identifier: BSD-3-Clause
#include "support/print.h"
#include "support/quick_judge.h"
#include "support/random.h"
#include "support/referee_turning.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace brink;
using namespace brink::support;

namespace {

/// The answer, mostly with a fault of any size in its time, or in what it says.
Toi planted(Random& random, const Query& q, Toi toi)
{
    const double size = random.log_between(1e-15, 1e-1);
    const int kind = random.index(6);
    if (toi.status == Status::invalid || kind == 5) return toi;
    if (kind < 2 && toi.status == Status::hit) {
        toi.t = std::min(q.options.t_max, toi.t + size);
        toi.t_upper = infinity;
    }
    if (kind == 2) {
        toi.t = std::max(0.0, toi.t - size);
        toi.status = Status::hit;
    }
    if (kind == 3) {
        toi.status = Status::separated;
        toi.t = q.options.t_max;
    }
    if (kind == 4 && toi.status == Status::hit) {
        toi.t = std::max(0.0, toi.t - size);
        toi.t_upper = toi.t + size * random.between(0, 2);
    }
    return toi;
}

} // namespace

TEST_CASE("quick judge: whatever it acquits of everything, the referee acquits")
{
    int strict = 0, guilty = 0, seen = 0;
    for (const Pair& pair : all_pairs()) {
        if (pair.unbounded()) continue;
        for (std::uint64_t i = 0; i < 100; ++i) {
            Query q = campaign_query(pair, 20261128, i, Aim::quick);
            Random random(20261128, i);
            q.options.detail = Detail::time_only;
            const Toi toi = planted(random, q, answer(q));
            const Quick quick = quick_judge(q, toi);
            if (quick.acquittal == Acquittal::none) {
                // What it does not acquit may be right, or a fault: count those that are.
                if (i % 5 == 0 && !rule(q, toi).findings.empty()) ++guilty;
                continue;
            }
            ++seen;
            if (quick.acquittal != Acquittal::strict) continue;
            ++strict;
            const Ruling ruling = rule(q, toi);
            CAPTURE(as_cpp(q, in_words(toi)));
            CHECK((ruling.findings.empty() || ruling.findings.front().check == "early"));
        }
    }
    CHECK(strict > 52 * 25);
    CHECK(guilty > 52 * 3);
    CHECK(seen > strict);
}
