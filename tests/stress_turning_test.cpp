// SPDX-License-Identifier: BSD-3-Clause
#include "support/reference.h"
#include "support/stress_turning.h"

#include <doctest/doctest.h>

#include <set>

using namespace brink;
using namespace brink::support;

namespace {

constexpr std::uint64_t seed = 20261122;
constexpr std::uint64_t cases = 24; // a pair and class

std::vector<Pair> bounded_pairs()
{
    std::vector<Pair> pairs = all_pairs();
    std::erase_if(pairs, [](const Pair& p) { return p.unbounded(); });
    return pairs;
}

} // namespace

TEST_CASE("stress that turns: every class is valid, hits and misses, and its levels cover their range")
{
    for (const TurningClass& c : turning_classes) {
        CAPTURE(c.name);
        std::size_t asked = 0, hits = 0, turning = 0;
        std::set<int> steps;
        for (const Pair& pair : bounded_pairs()) {
            CAPTURE(pair.name());
            for (std::uint64_t i = 0; i < cases; ++i) {
                const StressCase drawn = stress(pair, c.stress, seed, i);
                REQUIRE(drawn.level >= c.first);
                REQUIRE(drawn.level < c.last);
                steps.insert(static_cast<int>((drawn.level - c.first) / c.decades));
                const Query& q = drawn.query;
                const Status status = answer(q).status;
                CHECK(status != Status::invalid);
                hits += status == Status::hit || status == Status::touching ? 1U : 0U;
                turning += q.motion_a.rotation != Vec3(0, 0, 0) || q.motion_b.rotation != Vec3(0, 0, 0);
                ++asked;
            }
        }
        INFO("hits ", hits, " of ", asked);
        CHECK(hits > asked / 4);
        CHECK(hits < asked * 9 / 10);
        CHECK(turning > asked * 9 / 10);
        CHECK(steps.size() + 1 >= static_cast<std::size_t>((c.last - c.first) / c.decades));
    }
}

TEST_CASE("stress that turns: a function of its arguments, and another for another index")
{
    const Pair pair = *pair_named("box-hull");
    for (const TurningClass& c : turning_classes) {
        const Query one = stress(pair, c.stress, seed, 7).query;
        const Query same = stress(pair, c.stress, seed, 7).query;
        const Query other = stress(pair, c.stress, seed, 8).query;
        CHECK(one.motion_a.start.position == same.motion_a.start.position);
        CHECK(one.motion_a.rotation == same.motion_a.rotation);
        CHECK(one.options.tolerance == same.options.tolerance);
        CHECK(one.motion_a.start.position != other.motion_a.start.position);
    }
}

TEST_CASE("stress that turns: the first step of `angle` does not turn")
{
    const Pair pair = *pair_named("box-box");
    int still = 0;
    for (std::uint64_t i = 0; i < 400; ++i) {
        const StressCase drawn = stress(pair, TurningStress::angle, seed, i);
        if (drawn.level != described(TurningStress::angle).first) continue;
        CHECK(drawn.query.motion_a.rotation == Vec3(0, 0, 0));
        CHECK(drawn.query.motion_b.rotation == Vec3(0, 0, 0));
        ++still;
    }
    CHECK(still > 10);
}

TEST_CASE("stress that turns: what touches at the start does, as far as it is told")
{
    const Pair pair = *pair_named("capsule-box");
    int near = 0;
    for (std::uint64_t i = 0; i < 200; ++i) {
        const StressCase drawn = stress(pair, TurningStress::touching, seed, i);
        const Query& q = drawn.query;
        const auto gap = static_cast<double>(GapOverTime(q).at(0).gap) - q.options.target_gap;
        near += std::abs(gap) <= std::pow(10, drawn.level) + 1e-14 ? 1 : 0;
    }
    CHECK(near > 180);
}
