// SPDX-License-Identifier: BSD-3-Clause
#include "edge_step.h"
#include "support/turn_onto.h"
#include "two_bodies.h"

#include <brink/toi.h>
#include <doctest/doctest.h>

using namespace brink;
using support::Random;

TEST_CASE("edge_step: no gap opens into contact while the axis across two edges goes with them")
{
    Random random(181);
    int certified = 0, longer = 0, rounded = 0;
    for (int i = 0; i < 40'000; ++i) {
        const bool still = random.chance(0.5), grown = random.chance(0.3);
        Motion motion_a = random_motion(random, 2), motion_b = random_motion(random, 2);
        if (still) motion_b.rotation = Vec3(0, 0, 0);
        const bool segment = random.chance(0.5);
        const Shape a = segment ? random_shape(random, 0) : random_shape(random, 4), b = random_box(random);
        const TwoBodies<Core> scene{moving_core(a, motion_a), moving_core(b, motion_b)};
        const double t = random.between(0, 0.9);
        const Separation now = scene.at(t);
        const Moment<Core> s(scene, t);
        Facing<Core> f = s.facing();
        const double margin = grown && now.gap > 0 ? random.between(0.5, 1) * now.gap : 0;
        f.margin = margin;
        const Step step = edge_step(f, now.normal, 1 - t);
        if (!(step.gap > 1e-9)) continue;
        CAPTURE(i);
        CHECK(step.length > 0);
        CHECK(step.length <= 1 - t);
        CHECK(least_gap(scene, t, step.length) > margin - 1e-12);
        ++certified;
        rounded += margin > 0;
        longer += step.length > 1.01 * safe_step(f, {now.normal, {}}, 1 - t).length;
    }
    CHECK(certified > 8'000);
    CHECK(rounded > 2'000);
    CHECK(longer > 300);
}

TEST_CASE("edge_step: a bar that swings on its edge, a hair above another bar across")
{
    // Both edges are up to 1e-8 apart for a quarter of a turn about the first; the axis turns all the way.
    Motion swing;
    swing.start.position = Vec3(0, 0, 1 + 1e-8);
    swing.start.orientation = support::turn_onto(Vec3(0, -1, -1), Vec3(0, 0, -1));
    swing.pivot = Vec3(0, -0.70710678118654757, -0.70710678118654757);
    swing.rotation = Vec3(0, 0, 1);
    const Box bar{Vec3(3, 0.70710678118654757, 0.70710678118654757)};
    Motion still;
    still.start.orientation = Quat(Eigen::AngleAxisd(2.0, Vec3(0, 0, 1))) * swing.start.orientation;
    still.start.position = Vec3(0, 0, -1);
    swing.start.position = -(swing.start.orientation * swing.pivot) + Vec3(0, 0, 1e-8);
    const TwoBodies<Core> scene{mover(bar, swing), mover(bar, still)};
    const Separation now = scene.at(0);
    REQUIRE(now.gap == doctest::Approx(1e-8).epsilon(1e-3));
    const Step step = edge_step(Moment<Core>(scene, 0).facing(), now.normal, 1);
    CHECK(step.length > 0.1);
    CHECK(time_of_impact(bar, swing, bar, still).status == Status::separated);
}

TEST_CASE("edge_step: bars that swing on the place where their edges cross, which alone bends nothing")
{
    constexpr double half = 0.70710678118654757; // of a diagonal of 2
    Random random(182);
    int certified = 0, partly = 0;
    for (int i = 0; i < 4'000; ++i) {
        const double hair = random.log_between(1e-8, 1e-4), across = random.between(0.5, 2.6);
        Motion above, below;
        above.start.orientation = support::turn_onto(Vec3(0, -1, -1), Vec3(0, 0, -1));
        above.start.position = Vec3(0, 0, 1 + hair);
        above.pivot = Vec3(0, -half, -half);
        above.rotation = random.in_cube(3);
        below.start.orientation = Quat(Eigen::AngleAxisd(across, Vec3(0, 0, 1))) * above.start.orientation;
        below.start.position = Vec3(0, 0, -1);
        below.pivot = Vec3(0, half, half);
        if (random.chance(0.7)) below.rotation = random.in_cube(3);
        const double length = random.between(0.2, 3);
        const TwoBodies<Core> scene{mover(Box{Vec3(length, half, half)}, above),
                                    mover(Box{Vec3(length, half, half)}, below)};
        const Step step = edge_step(Moment<Core>(scene, 0).facing(), {0, 0, -1}, 1);
        if (!(step.gap > 0)) continue;
        CAPTURE(i);
        CHECK(least_gap(scene, 0, step.length) > -1e-12);
        ++certified;
        partly += step.length < 1;
    }
    CHECK(certified > 3'000);
    CHECK(partly > 2'000);
}

TEST_CASE("edge_step: nothing of shapes without edges")
{
    const TwoBodies<Core> scene{mover(Ellipsoid{Vec3(1, 1, 1)}, Motion{}),
                                mover(Box{Vec3(1, 1, 1)}, Motion{Pose{Vec3(9, 0, 0)}})};
    CHECK(edge_step(Moment<Core>(scene, 0).facing(), {1, 0, 0}, 1).length == 0);
}
