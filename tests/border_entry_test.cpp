// SPDX-License-Identifier: BSD-3-Clause
#include "against_advancement.h"
#include "support/moving.h"

#include <doctest/doctest.h>

using namespace brink;
using support::brackets;
using support::moving;
using support::near;
using support::resting;

namespace {

const Capsule slanted{Vec3(-1, 0, -2), Vec3(1, 0, 2), 0.5};

} // namespace

TEST_CASE_TEMPLATE("sphere against a plane or half-space: down onto it", Border, Plane, HalfSpace)
{
    const Border floor_at_1{Vec3(0, 0, 1), 1};
    const Toi toi =
        time_of_impact(Sphere{0.5}, moving(Vec3(3, 4, 5.5), Vec3(1, 0, -8)), floor_at_1, resting());
    CHECK(toi.status == Status::hit);
    CHECK(brackets(toi, 0.5));
    CHECK(toi.normal == Vec3(0, 0, -1));
    CHECK(near(toi.point_b, Vec3(3.5, 4, 1)));
}

TEST_CASE_TEMPLATE("sphere against a plane or half-space: along it, away, short of it, just reaching it",
                   Border, Plane, HalfSpace)
{
    const Border floor_at_1{Vec3(0, 0, 1), 1};
    const auto ask = [&](const Vec3& by) {
        return time_of_impact(Sphere{1}, moving(Vec3(0, 0, 3), by), floor_at_1, resting());
    };
    CHECK(ask(Vec3(5, 5, 0)).status == Status::separated);
    CHECK(ask(Vec3(0, 0, 5)).status == Status::separated);
    CHECK(ask(Vec3(0, 0, -0.9)).status == Status::separated);
    CHECK(brackets(ask(Vec3(0, 0, -1)), 1));
}

TEST_CASE_TEMPLATE("sphere against a plane or half-space: a normal a little off unit means the same set",
                   Border, Plane, HalfSpace)
{
    const double long_normal = 1 + 4e-7; // {x: n . x = n} is {z = 1}
    const Border same{Vec3(0, 0, long_normal), long_normal};
    const Toi toi = time_of_impact(Sphere{0.5}, moving(Vec3(0, 0, 5.5), Vec3(0, 0, -8)), same, resting());
    CHECK(brackets(toi, 0.5));
    CHECK(toi.normal.norm() == doctest::Approx(1).epsilon(1e-15));
}

TEST_CASE_TEMPLATE("sphere against a plane or half-space: the tiniest sphere has its normal exactly", Border,
                   Plane, HalfSpace)
{
    const Border slope{Vec3(0.6, 0, 0.8), 0};
    const Toi toi = time_of_impact(Sphere{1e-12}, moving(Vec3(3, 7, 4), Vec3(-6, 1, -8)), slope, resting());
    CHECK(toi.status == Status::hit);
    CHECK((toi.normal - Vec3(-0.6, 0, -0.8)).norm() < 1e-15);
}

TEST_CASE_TEMPLATE("capsule against a plane or half-space: the lower end comes first", Border, Plane,
                   HalfSpace)
{
    const Border floor_at_1{Vec3(0, 0, 1), 1};
    const Toi toi = time_of_impact(slanted, moving(Vec3(0, 0, 7.5), Vec3(0, 1, -8)), floor_at_1, resting());
    CHECK(toi.status == Status::hit);
    CHECK(brackets(toi, 0.5));
    CHECK(toi.normal == Vec3(0, 0, -1));
    CHECK(near(toi.point_a, Vec3(-1, 0.5, 1)));
    const Toi through = time_of_impact(slanted, moving(Vec3(0, 0, 1), Vec3(0, 0, 9)), floor_at_1, resting());
    CHECK(through.status == Status::touching);
}

TEST_CASE("a plane is seen from both sides, a half-space is solid below")
{
    const Motion rising = moving(Vec3(0, 0, -3.5), Vec3(0, 0, 8));
    const Toi onto = time_of_impact(Sphere{0.5}, rising, Plane{Vec3(0, 0, 1), 1}, resting());
    CHECK(brackets(onto, 0.5));
    CHECK(onto.normal == Vec3(0, 0, 1));
    const Toi within = time_of_impact(Sphere{0.5}, rising, HalfSpace{Vec3(0, 0, 1), 1}, resting());
    CHECK(within.status == Status::touching);
    CHECK(within.gap == -5);                                   // 1 + 3.5 + 0.5 to push it out
    const Motion up = moving(Vec3(0, 0, -5.5), Vec3(0, 0, 8)); // the upper end comes first
    CHECK(brackets(time_of_impact(slanted, up, Plane{Vec3(0, 0, 1), 1}, resting()), 0.5));
}

TEST_CASE_TEMPLATE("box and triangle against a plane or half-space: the lowest corner decides", Border, Plane,
                   HalfSpace)
{
    const Border floor_at_1{Vec3(0, 0, 1), 1};
    const Box box{Vec3(3, 2, 0.5)};
    const Toi flat = time_of_impact(box, moving(Vec3(3, 4, 5.5), Vec3(1, 0, -8)), floor_at_1, resting());
    CHECK(brackets(flat, 0.5)); // 5.5 - 0.5 - 1 = 4
    CHECK(flat.normal == Vec3(0, 0, -1));
    Motion tipped = moving(Vec3(0, 0, 7), Vec3(0, 0, -8));
    tipped.start.orientation = Quat(0.5, 0.5, 0.5, 0.5); // z along x, x along y, y along z: 7 - 2 - 1 = 4
    CHECK(brackets(time_of_impact(box, tipped, floor_at_1, resting()), 0.5));
    const Triangle slanted_one{Vec3(0, 0, 2), Vec3(1, 0, -1), Vec3(0, 1, 5)};
    const Toi corner =
        time_of_impact(slanted_one, moving(Vec3(3, 4, 6), Vec3(0, 0, -8)), floor_at_1, resting());
    CHECK(brackets(corner, 0.5));
    CHECK(near(corner.point_a, Vec3(4, 4, 1)));
    CHECK(near(corner.point_b, Vec3(4, 4, 1)));
    // Exactly reached, exactly not, and lying on it already.
    const auto ask = [&](double down) {
        return time_of_impact(box, moving(Vec3(0, 0, 2), Vec3(1, 1, -down)), floor_at_1, resting()).status;
    };
    CHECK(ask(0.5) == Status::hit);
    CHECK(ask(0.5 - 0x1p-53) == Status::separated);
    CHECK(time_of_impact(box, resting(Vec3(0, 0, 1.5)), floor_at_1, resting()).status == Status::touching);
    CHECK(time_of_impact(box, resting(Vec3(0, 0, 1.5 + 0x1p-52)), floor_at_1, resting()).status ==
          Status::separated);
}

TEST_CASE("box and triangle against a plane or half-space: held against advancement and the reference")
{
    for (const support::Pair& pair :
         {support::Pair{2, 4}, support::Pair{2, 5}, support::Pair{3, 4}, support::Pair{3, 5}}) {
        CAPTURE(pair.name());
        const tests::Held held = tests::hold_against_advancement(pair, 20261122, 25'000, 20);
        CHECK(held.hits > 5'000);
        CHECK(held.separated > 3'000);
        CHECK(held.touching > 500);
        CHECK(held.unproven == 0);
    }
}
