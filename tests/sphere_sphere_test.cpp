// SPDX-License-Identifier: BSD-3-Clause
#include "support/moving.h"

#include <doctest/doctest.h>

using namespace brink;
using support::brackets;
using support::moving;
using support::near;
using support::resting;

TEST_CASE("sphere-sphere: head-on, t is gap over speed")
{
    // Gap 5 - 1 - 0.5 = 3.5 m, closing at 7 m per step.
    const Toi toi = time_of_impact(Sphere{1}, moving(Vec3(5, 0, 0), Vec3(-7, 0, 0)), Sphere{0.5}, resting());
    CHECK(toi.status == Status::hit);
    CHECK(brackets(toi, 0.5));
    CHECK(toi.normal == Vec3(-1, 0, 0));
    CHECK(near(toi.point_a, Vec3(0.5, 0, 0)));
    CHECK(near(toi.point_b, Vec3(0.5, 0, 0)));
    CHECK(toi.gap == 0);
    CHECK(toi.iterations == 0);
}

TEST_CASE("sphere-sphere: tangency is contact, a hair beyond it is not")
{
    const Motion by = moving(Vec3(-3, 2, 0), Vec3(6, 0, 0));
    CHECK(brackets(time_of_impact(Sphere{1}, by, Sphere{1}, resting()), 0.5));
    CHECK(time_of_impact(Sphere{1}, by, Sphere{1 - 0x1p-40}, resting()).status == Status::separated);
}

TEST_CASE("sphere-sphere: both move, and only their difference counts")
{
    const Motion a = moving(Vec3(1e6 + 4, 0, 0), Vec3(100 - 8, 0, 0)),
                 b = moving(Vec3(1e6, 0, 0), Vec3(100, 0, 0));
    CHECK(brackets(time_of_impact(Sphere{1}, a, Sphere{1}, b), 0.25));
}

TEST_CASE("sphere-sphere: two points that meet, that pass, and that start together")
{
    const Motion a = moving(Vec3(1, 0, 0), Vec3(-2, 0, 0));
    const Toi meet = time_of_impact(Sphere{0}, a, Sphere{0}, resting());
    CHECK(brackets(meet, 0.5));
    CHECK(meet.normal == Vec3(-1, 0, 0)); // the way A comes, since the points themselves give none
    CHECK(time_of_impact(Sphere{0}, a, Sphere{0}, resting(Vec3(0, 1e-9, 0))).status == Status::separated);
    CHECK(time_of_impact(Sphere{0}, resting(), Sphere{0}, resting()).status == Status::touching);
}

TEST_CASE("sphere-sphere: a planet and a pebble just above it keep every digit of the gap")
{
    // Gap 1e-3 m above a radius of 1e8 m: the square of the distance has lost it, the pair of doubles has
    // not.
    const double height = 0x1p-10;
    const Motion fall = moving(Vec3(0, 0, 1e8 + 0.5 + height), Vec3(0, 0, -2 * height));
    const Toi toi = time_of_impact(Sphere{0.5}, fall, Sphere{1e8}, resting());
    const double gap = (1e8 + 0.5 + height) - 1e8 - 0.5; // exact: what the doubles say
    CHECK(toi.t == doctest::Approx(gap / (2 * height)).epsilon(1e-12));
}

TEST_CASE("sphere-sphere: a spinning sphere centred on its pivot only translates")
{
    Motion spinning = moving(Vec3(5, 0, 0), Vec3(-7, 0, 0));
    spinning.rotation = Vec3(100, 20, 3);
    spinning.start.orientation = Quat(0, 0, 0, 0); // no rotation at all: it cannot matter
    const Toi toi = time_of_impact(Sphere{1}, spinning, Sphere{0.5}, resting());
    CHECK(brackets(toi, 0.5));
    CHECK(toi.iterations == 0);
}
