// SPDX-License-Identifier: BSD-3-Clause
#include "corner_step.h"
#include "stride.h"
#include "two_bodies.h"

#include <brink/toi.h>
#include <doctest/doctest.h>

using namespace brink;
using support::Random;

TEST_CASE("stride: no gap opens into contact, whichever axis is found, one body at rest or none")
{
    Random random(191);
    int certified = 0, longer = 0;
    for (int i = 0; i < 12'000; ++i) {
        const Shape a = random_shape(random, i % 8), b = random_shape(random, i / 8 % 8);
        Motion motion_a = random_motion(random, 3), motion_b = random_motion(random, 3);
        const int still = random.index(4);
        if (still == 0) motion_a.rotation = Vec3(0, 0, 0);
        if (still == 1) motion_b.rotation = Vec3(0, 0, 0);
        const TwoBodies<Core> scene{moving_core(a, motion_a), moving_core(b, motion_b)};
        const double t = random.between(0, 0.9);
        const Separation now = scene.at(t);
        if (!(now.gap > 1e-9)) continue;
        const Moment<Core> s(scene, t);
        const Step step = stride(s.facing(), now.normal, 1 - t).step;
        CAPTURE(i);
        CHECK(step.length > 0);
        CHECK(step.length <= 1 - t);
        CHECK(least_gap(scene, t, step.length) > -1e-12);
        ++certified;
        longer += step.length > 1.5 * corner_step(s.facing(), {now.normal, {}}, 1 - t).length;
    }
    CHECK(certified > 6'000);
    CHECK(longer > 300);
}

TEST_CASE("whirl_step: an axis at rest that proves all turns at once")
{
    Random random(192);
    int certified = 0, whole = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Shape a = random_shape(random, i % 8), b = random_shape(random, i / 8 % 8);
        Motion motion_a = random_motion(random, 3), motion_b = random_motion(random, 3);
        motion_a.rotation *= 8;
        const TwoBodies<Core> scene{moving_core(a, motion_a), moving_core(b, motion_b)};
        const double t = random.between(0, 0.9);
        const Moment<Core> s(scene, t);
        const Step step = whirl_step(s.facing(), scene.at(t).normal, 1 - t);
        if (!(step.length > 0)) continue;
        CAPTURE(i);
        CHECK(least_gap(scene, t, step.length) > -1e-12);
        ++certified;
        whole += step.length == 1 - t;
    }
    CHECK(certified > 1'000);
    CHECK(whole > 200);
    CHECK(whole < certified);
}

TEST_CASE("corner_rise: a gap along an axis that does not fall, point by point")
{
    Random random(193);
    int risen = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto [scene, t, axis] = any_moment(random, i);
        const Moment<Core> s(scene, t);
        const Facing<Core> f = s.facing();
        const double length = corner_rise(f, axis, 1 - t), level = corner_step(f, axis, 0).gap;
        if (!(length > 0)) continue;
        CAPTURE(i);
        CHECK(least_gap(scene, t, length) >= level - 1e-12);
        ++risen;
    }
    CHECK(risen > 3'000);
}

TEST_CASE("stride: a corner over an edge, a hair away, with room to turn to one side only")
{
    // The way between them is at right angles to a face of A already, which turns down: another axis is
    // needed.
    Motion rocking;
    rocking.pivot = Vec3(-1, -1, -1);
    rocking.start.position = Vec3(1, 1, 1 + 1e-9);
    rocking.rotation = Vec3(0.3, 0.3, 0.1);
    const Box a{Vec3(1, 1, 1)}, b{Vec3(1, 1, 1)};
    Motion still;
    still.start.position = Vec3(-1, 0, -1);
    Options exacting;
    exacting.tolerance = 1e-12;
    const Toi toi = time_of_impact(a, rocking, b, still, exacting);
    CHECK(toi.status != Status::undecided);
    CHECK(toi.iterations <= 64);
}
