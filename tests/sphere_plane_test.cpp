// SPDX-License-Identifier: BSD-3-Clause
#include "support/moving.h"

#include <doctest/doctest.h>

using namespace brink;
using support::moving;
using support::resting;

namespace {

const Plane floor_at_1{Vec3(0, 0, 1), 1};

} // namespace

TEST_CASE("sphere-plane: down onto it")
{
    const Toi toi =
        time_of_impact(Sphere{0.5}, moving(Vec3(3, 4, 5.5), Vec3(1, 0, -8)), floor_at_1, resting());
    CHECK(toi.status == Status::hit);
    CHECK(toi.t == 0.5);
    CHECK(toi.normal == Vec3(0, 0, -1));
    CHECK(toi.point_b == Vec3(3.5, 4, 1));
}

TEST_CASE("sphere-plane: along it, away from it, short of it")
{
    CHECK(time_of_impact(Sphere{1}, moving(Vec3(0, 0, 3), Vec3(5, 5, 0)), floor_at_1, resting()).status ==
          Status::separated);
    CHECK(time_of_impact(Sphere{1}, moving(Vec3(0, 0, 3), Vec3(0, 0, 5)), floor_at_1, resting()).status ==
          Status::separated);
    CHECK(time_of_impact(Sphere{1}, moving(Vec3(0, 0, 3), Vec3(0, 0, -0.9)), floor_at_1, resting()).status ==
          Status::separated);
    CHECK(time_of_impact(Sphere{1}, moving(Vec3(0, 0, 3), Vec3(0, 0, -1)), floor_at_1, resting()).t == 1);
}

TEST_CASE("sphere-plane: a normal a little off unit still means the same set with true distances")
{
    const double long_normal = 1 + 4e-7; // {x: n . x = n} is {z = 1}
    const Plane same{Vec3(0, 0, long_normal), long_normal};
    const Toi toi = time_of_impact(Sphere{0.5}, moving(Vec3(0, 0, 5.5), Vec3(0, 0, -8)), same, resting());
    CHECK(toi.t == doctest::Approx(0.5).epsilon(1e-15));
    CHECK(toi.normal.norm() == doctest::Approx(1).epsilon(1e-15));
}

TEST_CASE("sphere-plane: seen from both sides")
{
    const Toi toi =
        time_of_impact(Sphere{0.5}, moving(Vec3(0, 0, -3.5), Vec3(0, 0, 8)), floor_at_1, resting());
    CHECK(toi.t == 0.5);
    CHECK(toi.normal == Vec3(0, 0, 1));
}
