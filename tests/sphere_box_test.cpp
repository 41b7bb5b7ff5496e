// SPDX-License-Identifier: BSD-3-Clause
#include "support/moving.h"

#include <doctest/doctest.h>

using namespace brink;
using support::brackets;
using support::moving;
using support::near;
using support::resting;

namespace {

const Box box{Vec3(1, 2, 3)};

Toi ask(const Vec3& from, const Vec3& by, double radius)
{
    return time_of_impact(Sphere{radius}, moving(from, by), box, resting());
}

} // namespace

TEST_CASE("sphere-box: faces")
{
    CHECK(brackets(ask(Vec3(5, 1, -2), Vec3(-7, 0, 0), 0.5), 0.5));
    CHECK(brackets(ask(Vec3(0, -6, 0), Vec3(0, 7, 0), 0.5), 0.5));
    CHECK(brackets(ask(Vec3(0.5, 1.5, 7), Vec3(0, 0, -7), 0.5), 0.5));
    const Toi toi = time_of_impact(Sphere{0.5}, moving(Vec3(5, 1, -2), Vec3(-7, 0, 0)), box, resting());
    CHECK(toi.normal == Vec3(-1, 0, 0));
    CHECK(near(toi.point_b, Vec3(1, 1, -2)));
}

TEST_CASE("sphere-box: an edge and a corner")
{
    // 3-4-5 in the plane of an edge: offset (3, 4) from it with radius 5.
    CHECK(brackets(ask(Vec3(8, 6, 0), Vec3(-8, 0, 0), 5), 0.5));
    // 2-3-6 is 7: offset (2, 3, 6) from the corner with radius 7.
    CHECK(brackets(ask(Vec3(7, 5, 9), Vec3(-8, 0, 0), 7), 0.5));
}

TEST_CASE("sphere-box: passes an edge that the grown box would have caught")
{
    CHECK(ask(Vec3(5, 2.9, 0), Vec3(-3, 0, 0), 1).status == Status::separated); // stops before the edge's arc
    CHECK(ask(Vec3(1.9, 6, 3.9), Vec3(0, -12, 0), 1).status ==
          Status::separated); // within the grown box, past the corner
    CHECK(ask(Vec3(1.6, 6, 3.75), Vec3(0, -12, 0), 1).t ==
          doctest::Approx(4.0 / 12 - std::sqrt(1 - 0.9225) / 12));
}

TEST_CASE("sphere-box: a point enters, a wall without thickness stops it, a box can be a point")
{
    CHECK(brackets(ask(Vec3(2, 0, 0), Vec3(-2, 0, 0), 0), 0.5));
    const Box wall{Vec3(0, 1, 1)}, point{Vec3(0, 0, 0)};
    const Toi toi = time_of_impact(Sphere{0}, moving(Vec3(1, 0, 0), Vec3(-2, 0, 0)), wall, resting());
    CHECK(brackets(toi, 0.5));
    CHECK(toi.normal == Vec3(-1, 0, 0));
    CHECK(brackets(time_of_impact(Sphere{1}, moving(Vec3(3, 0, 0), Vec3(-4, 0, 0)), point, resting()), 0.5));
}

TEST_CASE("sphere-box: inside, resting on a face, sliding along it")
{
    CHECK(time_of_impact(Sphere{1}, resting(), box, resting()).status == Status::touching);
    CHECK(time_of_impact(Sphere{1}, moving(Vec3(0, 0, 4), Vec3(1, 0, 0)), box, resting()).status ==
          Status::touching);
    const Motion above = moving(Vec3(0, 0, 4 + 0x1p-40), Vec3(1, 0, 0));
    CHECK(time_of_impact(Sphere{1}, above, box, resting()).status == Status::separated);
}
