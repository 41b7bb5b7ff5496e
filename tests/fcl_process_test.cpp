// SPDX-License-Identifier: BSD-3-Clause
#include "support/fcl_process.h"

#include <doctest/doctest.h>

namespace brink::tests {

using namespace support;

TEST_CASE("FCL's process: hulls made after it began are the same to it")
{
    FclProcess process;
    int distances = 0;
    for (std::uint64_t round = 0; round < 4; ++round) {
        std::vector<Hearing> hearings;
        for (std::uint64_t i = 0; i < 100; ++i) {
            Hearing hearing{query(*pair_named("sphere-hull"), Family::any, 3, round * 100 + i), {}, 1};
            hearings.push_back(hearing);
        }
        const std::vector<Testimony> there = process.hear(hearings);
        for (std::size_t i = 0; i < hearings.size(); ++i) {
            CAPTURE(i);
            CHECK(there[i].ending == Ending::answered);
            const Testimony here = testify(hearings[i]);
            CHECK(there[i].at[0].distance == here.at[0].distance);
            distances += here.at[0].distance && *here.at[0].distance > 0 ? 1 : 0;
        }
    }
    CHECK(distances > 200);
    CHECK(process.crashes() == 0);
}

} // namespace brink::tests
