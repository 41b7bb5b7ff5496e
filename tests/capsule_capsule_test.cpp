// SPDX-License-Identifier: BSD-3-Clause
#include "support/moving.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace brink;
using support::brackets;
using support::moving;
using support::near;
using support::resting;

namespace {

const Capsule along_x{Vec3(-2, 0, 0), Vec3(2, 0, 0), 0.5}, along_y{Vec3(0, -2, 0), Vec3(0, 2, 0), 0.25};

} // namespace

TEST_CASE("capsule-capsule: crossed")
{
    const Toi toi = time_of_impact(along_x, moving(Vec3(1, 1, 4.75), Vec3(0, 0, -8)), along_y, resting());
    CHECK(brackets(toi, 0.5));
    CHECK(toi.normal == Vec3(0, 0, -1));
    CHECK(near(toi.point_a, Vec3(0, 1, 0.25)));
    CHECK(near(toi.point_b, Vec3(0, 1, 0.25)));
}

TEST_CASE("capsule-capsule: side by side, end to end, end against side")
{
    const Motion beside = moving(Vec3(1, 5, 0), Vec3(0, -8, 0)),
                 ahead = moving(Vec3(9, 0, 0), Vec3(-8, 0, 0));
    CHECK(brackets(time_of_impact(along_x, beside, along_x, resting()), 0.5));
    CHECK(brackets(time_of_impact(along_x, ahead, along_x, resting()), 0.5));
    const Motion end_on = moving(Vec3(0, 6.75, 0), Vec3(0, -8, 0));
    CHECK(brackets(time_of_impact(along_y, end_on, along_x, resting()), 0.5));
    CHECK(
        time_of_impact(along_x, moving(Vec3(5 + 0x1p-40, 5, 0), Vec3(0, -9, 0)), along_x, resting()).status ==
        Status::separated);
}

TEST_CASE("capsule-capsule: without radius, two segments cross and their normal is that of both")
{
    const Capsule a{along_x.a, along_x.b, 0}, b{along_y.a, along_y.b, 0};
    const Toi toi = time_of_impact(a, moving(Vec3(0.5, 0.5, 2), Vec3(0, 0, -4)), b, resting());
    CHECK(brackets(toi, 0.5));
    CHECK(toi.normal == Vec3(0, 0, -1));
}

TEST_CASE("capsule-capsule: nearly parallel")
{
    const Capsule tilted{Vec3(-2, 0, 1e-9), Vec3(2, 0, -1e-9), 0.5};
    const Toi toi = time_of_impact(tilted, moving(Vec3(0, 0, 5), Vec3(0, 0, -8)), along_x, resting());
    CHECK(toi.t == doctest::Approx((4 - 1e-9) / 8).epsilon(1e-14));
}

TEST_CASE(
    "capsule-capsule: nearly parallel, one just past the other's end, is not met over the tip of a sliver")
{
    const double past = 0.01; // beyond the end, so the rounded end is met: 1^2 = past^2 + height^2
    for (double tilt = 1e-17; tilt < 1e-6; tilt *= 3) {
        const Capsule tilted{Vec3(-2, -tilt, 0), Vec3(2, tilt, 0), 0.5};
        const Toi toi =
            time_of_impact(tilted, moving(Vec3(4 + past, 0, 5), Vec3(0, 0, -8)), along_x, resting());
        CAPTURE(tilt);
        CHECK(toi.t == doctest::Approx((5 - std::sqrt(1 - past * past)) / 8).epsilon(1e-12));
    }
}
