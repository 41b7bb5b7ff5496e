// SPDX-License-Identifier: BSD-3-Clause
#include "brute_force.h"
#include "sight.h"
#include "solid_cores.h"
#include "two_bodies.h"

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

TEST_CASE("watch: a look ahead shows what a look does, and of hulls that overlap nothing")
{
    SolidCores cores(115);
    int seen = 0, nothing = 0;
    for (int i = 0; i < 4'000; ++i) {
        const auto [a, b] = cores.pair(3, 3); // hulls
        const Core apart = placed(b, {}, 4 * load(cores.random.unit()));
        Watch watch(a, apart, 0);
        watch.look(facing(a, apart)); // from afar
        Watch ahead = watch;
        const Sight s = ahead.look_ahead(facing(a, b));
        CAPTURE(i);
        const double gap = separation(a, b).gap;
        if (gap > 1e-9) {
            const Sight look = watch.look(facing(a, b));
            CHECK(s.normal == look.normal);
            CHECK(s.upper == look.upper);
            CHECK(s.point_a == look.point_a);
            CHECK(std::fabs(s.upper - gap) <= 1e-9);
            ++seen;
        } else if (gap < -1e-9) {
            CHECK(s.normal == V3{});
            CHECK(s.upper == infinity);
            ++nothing;
        }
    }
    CHECK(seen > 500);
    CHECK(nothing > 500);
}

TEST_CASE("watch: an axis that was followed past the other body tells no overlap of what is apart")
{
    // As of box-hull 514474 and capsule-hull 468787 of seed 2031, which passed each other beside their ends:
    // lines that cross, B on the other side than it was.
    Core along_x = core(Capsule{Vec3(-1, 0, 0), Vec3(1, 0, 0), 0});
    Core along_y = core(Capsule{Vec3(0, -1, 0), Vec3(0, 1, 0), 0});
    const Core before = placed(along_y, {}, {0.5, 0.2, 1e-9}), past = placed(along_y, {}, {0.5, 0.2, -1e-9});
    Sight s;
    s.axis.normal = s.normal = {0, 0, 1}; // from A towards where B was
    s.upper = 1e-9;
    s.point_a = {0.5, 0, 0};
    s.v = {0, 0, 1e-9};
    const auto told = shown(s, facing(along_x, before), 1e-15);
    REQUIRE(told.has_value());
    CHECK(told->gap == 1e-9);
    s.v = {0, 0, -1e-9};
    CHECK_FALSE(shown(s, facing(along_x, past), 1e-15).has_value());
    s.axis.normal = s.normal = {0, 0, -1};
    REQUIRE(shown(s, facing(along_x, past), 1e-15).has_value());
    CHECK(shown(s, facing(along_x, past), 1e-15)->gap == 1e-9);
    along_y.radius = along_x.radius = 0.1; // radii that overlap are told as ever
    CHECK(shown(s, facing(along_x, placed(along_y, {}, {0.5, 0.2, -1e-9})), 1e-15)->gap ==
          doctest::Approx(-0.2));
}

TEST_CASE("watch: a point and a cylinder or cone in closed form, as GJK sees them")
{
    SolidCores cores(113);
    int apart = 0, tilted = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Core round =
            placed(cores.local(i % 2), rotation(cores.random.rotation()), load(cores.random.in_cube(1)));
        const Core p = placed(core(Sphere{}), {}, 2 * load(cores.random.in_cube(1)));
        const Facing<Core> f = facing(p, round);
        Watch watch(p, round, 0);
        const Sight s = watch.look(f), by_gjk = Watch(p, round, 0).look_closely(f);
        const double rounding = 64 * eps * std::max(extent(p), extent(round));
        CAPTURE(i);
        CHECK(std::fabs(norm(s.normal) - 1) <= 8 * eps);
        CHECK(s.upper - gap_along(p, round, s.normal) <= rounding);
        if (!(by_gjk.upper > 1e-6)) continue;
        CHECK(std::fabs(s.upper - by_gjk.upper) <= 1e-9 * s.upper);
        CHECK(norm(s.point_a - p.points[0]) == 0);
        CHECK(std::fabs(norm(s.v) - s.upper) <= rounding);
        tilted += !(norm(s.axis.normal - s.normal) <= 1e-9);
        ++apart;
    }
    CHECK(apart > 15'000);
    CHECK(tilted == 0);
}

TEST_CASE("watch: the axis between a point and a cylinder or cone turns with what it looks at")
{
    SolidCores cores(114);
    const double later = 1e-5; // of the step
    int apart = 0, lost = 0, at_rest = 0;
    for (int i = 0; i < 4'000; ++i) {
        const Motion of_a = random_motion(cores.random, 2), of_b = random_motion(cores.random, 2);
        const TwoBodies<Core> bodies{mover(core(Sphere{}), of_a), mover(cores.local(i % 2), of_b)};
        const Moment<Core> now(bodies, 0.5), then(bodies, 0.5 + later);
        const double gap = bodies.at(0.5 + later).gap;
        if (!(gap > 0.01)) continue;
        Watch watch(now.a, now.b, 0);
        const TurningAxis axis = watch.look(now.facing()).axis;
        const V3 n = axis.normal + later * cross(axis.spin, axis.normal);
        ++apart;
        lost += gap - gap_along(then.a, then.b, (1 / norm(n)) * n) > 1e-7;
        at_rest += gap - gap_along(then.a, then.b, axis.normal) > 1e-7;
    }
    CHECK(apart > 2'000);
    CHECK(lost < 0.02 * apart); // where the nearest part is about to be another
    CHECK(at_rest > 0.1 * apart);
}
