// SPDX-License-Identifier: BSD-3-Clause
#include "brute_force.h"
#include "sight.h"
#include "solid_cores.h"

#include <doctest/doctest.h>

using namespace brink;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

Facing<Core> facing(const Core& a, const Core& b)
{
    return {{a, {}, reach(a), {}, 0}, {b, {}, reach(b), {}, 0}, {}, 0};
}

/// How far apart at least the supporting planes of two bodies keep them, over directions at random and that
/// of the separation.
double apart(support::Random& random, const Core& a, const Core& b)
{
    double most = gap_along(a, b, separation(a, b).normal);
    for (int i = 0; i < 100; ++i)
        most = std::max(most, gap_along(a, b, load(random.unit())));
    return most;
}

/// What to ask for: anything, and often about as much as there is.
double around(support::Random& random, double depth)
{
    const double any = random.log_between(1e-12, 0.5), part = random.between(0.1, 2);
    return depth > 0 && random.chance(0.7) ? part * depth : any;
}

struct Tally {
    int shown = 0, deep = 0, shallow = 0;
};

/// `gap`: the signed distance, or a lower bound of it.
void check_overlap(const Watch& watch, const Core& a, const Core& b, double gap, double least, Tally& tally)
{
    const double rounding = 64 * eps * std::max(extent(a), extent(b));
    const bool shown = watch.overlap(facing(a, b), least);
    if (shown) CHECK(gap <= -least + rounding);
    tally.shown += shown && gap < -2 * least;
    tally.deep += gap < -2 * least;
    tally.shallow += gap < 0 && gap > -least;
}

} // namespace

TEST_CASE("watch: an overlap is shown only as deep as separating axes find it")
{
    NastyCores cores(111);
    const Core::Kind kinds[] = {Core::Kind::segment, Core::Kind::triangle, Core::Kind::box};
    Tally fresh, warm;
    for (int i = 0; i < 30'000; ++i) {
        const auto [a, b] = cores.pair(kinds[i % 3], kinds[i / 3 % 3]);
        const double gap = brute::distance(a, b), least = around(cores.random, -gap);
        const V3 beside = least * load(cores.random.unit());
        Watch watch(a, b, 0);
        CAPTURE(i);
        check_overlap(watch, a, b, gap, least, fresh);
        watch.look_closely(
            facing(a, placed(b, {}, (std::max(0.0, -gap) + 1e-3) * separation(a, b).normal + beside)));
        check_overlap(watch, a, b, gap, least, warm);
    }
    for (const Tally& tally : {fresh, warm}) {
        CHECK(tally.deep > 800);
        CHECK(tally.shown > 0.8 * tally.deep);
        CHECK(tally.shallow > 1'500);
    }
}

TEST_CASE("watch: and curved bodies only as deep as their supporting planes say")
{
    SolidCores cores(112);
    Tally tally;
    for (int i = 0; i < 10'000; ++i) {
        const auto [a, b] = cores.pair(i % 5, i / 5 % 8);
        const double gap = apart(cores.random, a, b), least = around(cores.random, -gap);
        CAPTURE(i);
        check_overlap(Watch(a, b, 0), a, b, gap, least, tally);
    }
    CHECK(tally.deep > 1'500);
    CHECK(tally.shown > 0.5 * tally.deep);
    CHECK(tally.shallow > 1'500);
}
