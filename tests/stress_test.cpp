// SPDX-License-Identifier: BSD-3-Clause
#include "support/reference.h"
#include "support/stress.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace brink;
using namespace brink::support;

namespace {

constexpr std::uint64_t seed = 20261122;
constexpr std::uint64_t cases = 400; // a pair and class

std::vector<Pair> closed_forms()
{
    std::vector<Pair> pairs = all_pairs();
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), [](const Pair& p) { return !p.closed_form(); }),
                pairs.end());
    return pairs;
}

bool contact(const Query& q) { return reference(q, GapOverTime(q)).contact; }

} // namespace

TEST_CASE("stress: about half of the cases of each class hit, and the levels cover their range")
{
    for (const Pair& pair : closed_forms()) {
        for (const StressClass& c : stress_classes) {
            CAPTURE(pair.name());
            CAPTURE(c.name);
            std::uint64_t hits = 0;
            std::set<int> steps;
            for (std::uint64_t i = 0; i < cases; ++i) {
                const StressCase drawn = stress(pair, c.stress, seed, i);
                REQUIRE(drawn.level >= c.first);
                REQUIRE(drawn.level < c.last);
                steps.insert(static_cast<int>((drawn.level - c.first) / c.decades));
                hits += contact(drawn.query) ? 1U : 0U;
            }
            INFO("hits ", hits);
            CHECK(hits > cases / 4);
            CHECK(hits < cases * 17 / 20);
            CHECK(steps.size() * 4 >= 3 * static_cast<std::size_t>((c.last - c.first) / c.decades));
        }
    }
}

TEST_CASE("stress: a function of its arguments, and another for another index")
{
    const Pair pair = *pair_named("sphere-box");
    for (const StressClass& c : stress_classes) {
        const Query one = stress(pair, c.stress, seed, 7).query;
        const Query same = stress(pair, c.stress, seed, 7).query;
        const Query other = stress(pair, c.stress, seed, 8).query;
        CHECK(one.motion_a.start.position == same.motion_a.start.position);
        CHECK(one.motion_a.translation == same.motion_a.translation);
        CHECK(one.options.t_max == same.options.t_max);
        CHECK(one.motion_a.start.position != other.motion_a.start.position);
    }
}

TEST_CASE("stress: exact touching is exact, and none is an invalid query")
{
    for (const Pair& pair : closed_forms()) {
        int touching = 0;
        for (std::uint64_t i = 0; i < cases; ++i) {
            const StressCase drawn = stress(pair, Stress::touching, seed, i);
            CAPTURE(pair.name());
            CAPTURE(i);
            CHECK(answer(drawn.query).status != Status::invalid);
            if (drawn.level != described(Stress::touching).first) continue;
            CHECK(std::abs(GapOverTime(drawn.query).at(0).gap) < 1e-17L);
            ++touching;
        }
        CHECK(touching > 20);
    }
}
