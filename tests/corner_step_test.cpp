// SPDX-License-Identifier: BSD-3-Clause
#include "corner_step.h"
#include "support/turn_onto.h"
#include "two_bodies.h"

#include <brink/toi.h>
#include <doctest/doctest.h>

#include <cmath>

using namespace brink;
using support::Random;

TEST_CASE("corner_step: no gap opens into contact within a certified step, whatever the axis and its spin")
{
    Random random(171);
    int certified = 0, longer = 0;
    for (int i = 0; i < 40'000; ++i) {
        const auto [scene, t, axis] = any_moment(random, i);
        const Moment<Core> s(scene, t);
        const double horizon = 1 - t;
        const Step step = corner_step(s.facing(), axis, horizon);
        if (!(step.gap > 1e-9)) continue;
        CAPTURE(i);
        CHECK(step.length > 0);
        CHECK(step.length <= horizon);
        CHECK(least_gap(scene, t, step.length) > -1e-12);
        ++certified;
        longer += step.length > 1.01 * safe_step(s.facing(), axis, horizon).length;
    }
    CHECK(certified > 10'000);
    CHECK(longer > 500);
}

TEST_CASE("corner_step: a plane that turns and a body that does")
{
    Random random(172);
    int certified = 0, alone = 0;
    for (int i = 0; i < 20'000; ++i) {
        Motion motion_a = random_motion(random, 3), motion_b = random_motion(random, 3);
        const int still = random.index(4); // one of them or, half of the time, none
        if (still == 0) motion_a.rotation = Vec3(0, 0, 0);
        if (still == 1) motion_b.rotation = Vec3(0, 0, 0);
        const TwoBodies<Border> scene{moving_core(random_shape(random, i % 8), motion_a),
                                      mover(Plane{random.unit(), 0}, motion_b)};
        const double t = random.between(0, 0.9);
        const Moment<Border> s(scene, t);
        const TurningAxis axis{scene.at(t).normal, scene.b.turn.rate};
        const Step step = corner_step(s.facing(), axis, 1 - t);
        if (!(step.gap > 1e-9)) continue;
        CAPTURE(i);
        CHECK(least_gap(scene, t, step.length) > -1e-12);
        ++certified;
        alone += still == 0;
    }
    CHECK(certified > 5'000);
    CHECK(alone > 1'000);
}

TEST_CASE("corner_step: a floor that rocks about a point of its own, a hair below a cube's corner")
{
    // The cube is at rest: its pivot may lie in the corner, however far off the centre is.
    Motion resting, rocking;
    resting.start.orientation = support::turn_onto(Vec3(-1, -1, -1), Vec3(0, 0, -1));
    resting.start.position = Vec3(0, 0, 1e-6 + std::sqrt(3.0));
    rocking.rotation = Vec3(0.3, 0, 0);
    const Plane floor{Vec3(0, 0, 1), 0};
    const TwoBodies<Border> scene{mover(Box{Vec3(1, 1, 1)}, resting), mover(floor, rocking)};
    const Moment<Border> s(scene, 0);
    const TurningAxis down{{0, 0, -1}, {0.3, 0, 0}};
    CHECK(safe_step(s.facing(), down, 1).length < 0.02);
    CHECK(corner_step(s.facing(), down, 1).length == 1);
    CHECK(time_of_impact(Box{Vec3(1, 1, 1)}, resting, floor, rocking).status == Status::separated);
}

TEST_CASE("corner_step: a cube that rocks on its corner a hair above a floor")
{
    // Its edges rise at 35 degrees from there; 17 degrees of rocking bring none of them down.
    const double height = 1e-6;
    const Vec3 corner(-1, -1, -1);
    Motion rocking;
    rocking.start.orientation = support::turn_onto(corner, Vec3(0, 0, -1));
    rocking.start.position = Vec3(0, 0, height) - rocking.start.orientation * corner;
    rocking.pivot = corner;
    rocking.rotation = Vec3(0.3, 0, 0);
    const Motion still{Pose{Vec3(0, 0, -1)}};
    const TwoBodies<Core> scene{mover(Box{Vec3(1, 1, 1)}, rocking), mover(Box{Vec3(9, 9, 1)}, still)};
    const Moment<Core> s(scene, 0);
    const TurningAxis down{{0, 0, -1}, {}};
    CHECK(safe_step(s.facing(), down, 1).length < 0.02);
    CHECK(corner_step(s.facing(), down, 1).length == 1);
    const Toi toi = time_of_impact(Box{Vec3(1, 1, 1)}, rocking, Box{Vec3(9, 9, 1)}, still);
    CHECK(toi.status == Status::separated);
}
