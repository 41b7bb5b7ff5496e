// SPDX-License-Identifier: BSD-3-Clause
#include "support/moving.h"

#include <doctest/doctest.h>

using namespace brink;
using support::brackets;
using support::moving;
using support::near;
using support::resting;

namespace {

const Capsule upright{Vec3(0, 0, -2), Vec3(0, 0, 2), 0.5};

} // namespace

TEST_CASE("sphere-capsule: against the side")
{
    const Toi toi = time_of_impact(Sphere{1}, moving(Vec3(5, 0, 1), Vec3(-7, 0, 0)), upright, resting());
    CHECK(brackets(toi, 0.5));
    CHECK(toi.normal == Vec3(-1, 0, 0));
    CHECK(near(toi.point_b, Vec3(0.5, 0, 1)));
}

TEST_CASE("sphere-capsule: against an end, head-on and past the side's reach")
{
    CHECK(
        brackets(time_of_impact(Sphere{1}, moving(Vec3(0, 0, 8), Vec3(0, 0, -9)), upright, resting()), 0.5));
    // 3-4-5: the centre meets the end at (0.9, 0, 3.2), 1.5 from it.
    const Toi corner =
        time_of_impact(Sphere{1}, moving(Vec3(4.9, 0, 3.2), Vec3(-8, 0, 0)), upright, resting());
    CHECK(brackets(corner, 0.5));
    CHECK(corner.normal.x() == doctest::Approx(-0.6));
    CHECK(corner.normal.z() == doctest::Approx(-0.8));
}

TEST_CASE("sphere-capsule: along the axis, beside it, and inside the infinite cylinder")
{
    const Motion along = moving(Vec3(1.5, 0, 6), Vec3(0, 0, -8)); // grazes the side from end to end
    CHECK(brackets(time_of_impact(Sphere{1}, along, upright, resting()), 0.5));
    const Motion beside = moving(Vec3(1.5 + 0x1p-40, 0, 6), Vec3(0, 0, -8));
    CHECK(time_of_impact(Sphere{1}, beside, upright, resting()).status == Status::separated);
    const Motion near_axis = moving(Vec3(0.25, 0, 8), Vec3(0, 0, -9));
    CHECK(time_of_impact(Sphere{1}, near_axis, upright, resting()).t > 0.5);
}

TEST_CASE("sphere-capsule: coincident points are a sphere")
{
    const Capsule ball{Vec3(1, 1, 1), Vec3(1, 1, 1), 0.5};
    CHECK(brackets(time_of_impact(Sphere{1}, moving(Vec3(6, 1, 1), Vec3(-7, 0, 0)), ball, resting()), 0.5));
    CHECK(time_of_impact(Sphere{1}, moving(Vec3(6, 3, 1), Vec3(-7, 0, 0)), ball, resting()).status ==
          Status::separated);
}

TEST_CASE("sphere-capsule: the capsule's own orientation counts")
{
    const double half = 0.70710678118654752; // a quarter turn about y lays it along x
    const Motion lying{.start = {Vec3(0, 0, 0), Quat(half, 0, half, 0)}};
    const Toi toi = time_of_impact(Sphere{1}, moving(Vec3(8, 0, 0), Vec3(-9, 0, 0)), upright, lying);
    CHECK(brackets(toi, 0.5));
    CHECK(toi.status == Status::hit);
}
