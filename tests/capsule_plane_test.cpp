// SPDX-License-Identifier: BSD-3-Clause
#include "support/moving.h"

#include <doctest/doctest.h>

using namespace brink;
using support::moving;
using support::resting;

namespace {

const Plane floor_at_1{Vec3(0, 0, 1), 1};
const Capsule slanted{Vec3(-1, 0, -2), Vec3(1, 0, 2), 0.5};

} // namespace

TEST_CASE("capsule-plane: the lower end comes first")
{
    const Toi toi = time_of_impact(slanted, moving(Vec3(0, 0, 7.5), Vec3(0, 1, -8)), floor_at_1, resting());
    CHECK(toi.status == Status::hit);
    CHECK(toi.t == 0.5);
    CHECK(toi.normal == Vec3(0, 0, -1));
    CHECK(toi.point_a == Vec3(-1, 0.5, 1));
}

TEST_CASE("capsule-plane: in contact wherever it reaches through")
{
    CHECK(time_of_impact(slanted, moving(Vec3(0, 0, 1), Vec3(0, 0, 9)), floor_at_1, resting()).status ==
          Status::touching);
}

TEST_CASE("capsule-plane: from below the upper end comes first")
{
    CHECK(time_of_impact(slanted, moving(Vec3(0, 0, -5.5), Vec3(0, 0, 8)), floor_at_1, resting()).t == 0.5);
}
