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

const Triangle triangle{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

Toi ask(const Vec3& from, const Vec3& by, double radius, const Triangle& t = triangle)
{
    return time_of_impact(Sphere{radius}, moving(from, by), t, resting());
}

} // namespace

TEST_CASE("sphere-triangle: both sides of the face")
{
    const Toi above = ask(Vec3(1, 1, 5), Vec3(0, 0, -8), 1), below = ask(Vec3(1, 1, -5), Vec3(0, 0, 8), 1);
    CHECK(brackets(above, 0.5));
    CHECK(above.normal == Vec3(0, 0, -1));
    CHECK(near(above.point_b, Vec3(1, 1, 0)));
    CHECK(brackets(below, 0.5));
    CHECK(below.normal == Vec3(0, 0, 1));
}

TEST_CASE("sphere-triangle: an edge, a corner, and past both")
{
    // 3-4-5: the centre comes down 3 beside the edge y = 0 with radius 5, so it stops 4 above.
    CHECK(brackets(ask(Vec3(2, -3, 8), Vec3(0, 0, -8), 5), 0.5));
    // 2-3-6 is 7: beside the corner at the origin.
    CHECK(brackets(ask(Vec3(-2, -3, 10), Vec3(0, 0, -8), 7), 0.5));
    CHECK(ask(Vec3(2, -3, 8), Vec3(0, 0, -16), 2.9).status == Status::separated);
}

TEST_CASE("sphere-triangle: in its plane, edge-on")
{
    const Toi toi = ask(Vec3(1, -5, 0), Vec3(0, 8, 0), 1);
    CHECK(brackets(toi, 0.5));
    CHECK(toi.normal == Vec3(0, 1, 0));
    CHECK(brackets(ask(Vec3(1, -5, 0), Vec3(0, 10, 0), 0), 0.5)); // a point in the plane
}

TEST_CASE("sphere-triangle: degenerate to a segment and to a point")
{
    const Triangle segment{Vec3(0, 0, -2), Vec3(0, 0, 2), Vec3(0, 0, 1)},
        point{Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0)};
    CHECK(brackets(ask(Vec3(5, 0, 1), Vec3(-8, 0, 0), 1, segment), 0.5));
    CHECK(brackets(ask(Vec3(5, 0, 0), Vec3(-8, 0, 0), 1, point), 0.5));
    CHECK(ask(Vec3(5, 2, 0), Vec3(-8, 0, 0), 1, point).status == Status::separated);
}

TEST_CASE("sphere-triangle: just past the tip of a needle")
{
    const double past = 0.01;
    for (double width = 1e-17; width < 1e-6; width *= 3) {
        const Triangle needle{Vec3(-2, 0, 0), Vec3(2, 0, 0), Vec3(0.3, width, 0)};
        const Toi toi = ask(Vec3(2 + past, 0, 5), Vec3(0, 0, -8), 1, needle);
        CAPTURE(width);
        CHECK(toi.t == doctest::Approx((5 - std::sqrt(1 - past * past)) / 8).epsilon(1e-12));
    }
}
