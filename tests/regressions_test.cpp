// SPDX-License-Identifier: BSD-3-Clause
#include "support/print.h"
#include "support/verdict.h"

#include <doctest/doctest.h>

using namespace brink;
using namespace brink::support;

namespace {

/// Every check that brink-fuzz makes, on one query. Paste what it prints into a test case here.
void check(const Query& q)
{
    Trial trial(q);
    CAPTURE(in_words(trial.toi()));
    for (const Finding& finding : judge(trial))
        FAIL_CHECK(finding.check, ": ", finding.detail, "\n", as_cpp(q));
}

} // namespace

TEST_CASE("regression: parallel capsules in a rotated frame, whose axes differ by rounding alone")
{
    // Was `separated`, though they overlap by 0.22.
    check(Query{
        Capsule{Vec3(-0x1.31533eb1ac70ep-1, 0, 0), Vec3(0x1.31533eb1ac70ep-1, 0, 0), 0x1.42c58e041f7b6p-2},
        Motion{Pose{Vec3(0x1.6d7adda7a4558p-2, 0x1.55788c90c62bcp+1, 0x1.13f81ef272458p+2),
                    Quat(0x1.0d0cf5e87e78cp-2, -0x1.8b8dc52a3d9bbp-2, 0x1.b3d8fdab56a58p-1,
                         -0x1.e960693b5a7fp-3)},
               Vec3(0x1.06edc0a7ad876p+1, -0x1.7ec36cf33f665p-4, -0x1.943656b94c0a7p+1), Vec3(0, 0, 0),
               Vec3(0, 0, 0)},
        Capsule{Vec3(-0x1.351321294d645p-1, 0, 0), Vec3(0x1.351321294d645p-1, 0, 0), 0x1.2a374c378eb98p-1},
        Motion{Pose{Vec3(0x1.feb3c2c6f4cfap+0, 0x1.5693467f49bdap+0, 0x1.640d4ddbf652cp+0),
                    Quat(0x1.0d0cf5e87e78cp-2, -0x1.8b8dc52a3d9bbp-2, 0x1.b3d8fdab56a58p-1,
                         -0x1.e960693b5a7fp-3)},
               Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0)},
        Options{}});
}
