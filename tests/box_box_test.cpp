// SPDX-License-Identifier: BSD-3-Clause
#include "against_advancement.h"
#include "support/moving.h"

using namespace brink;
using support::brackets;
using support::moving;
using support::near;
using support::resting;

namespace {

const Box cube{Vec3(1, 1, 1)}, plank{Vec3(3, 0.5, 0.25)};

const Quat permuting(0.5, 0.5, 0.5, 0.5); // by 120 degrees about (1, 1, 1): x to y, y to z, z to x
const double half = 0.70710678118654752;
const Quat eighth(0.92387953251128674, 0, 0, 0.38268343236508977); // 45 degrees about z

Motion turned(Motion motion, const Quat& q)
{
    motion.start.orientation = q;
    return motion;
}

} // namespace

TEST_CASE("box-box: faces of equal boxes meet at gap over speed")
{
    // 5 - 1 - 1 = 3 at 6 per step.
    for (const Vec3& off : {Vec3(0, 0, 0), Vec3(0, 0.5, -0.25), Vec3(0, 1.75, 1.75)}) {
        const Toi toi = time_of_impact(cube, moving(Vec3(5, 0, 0) + off, Vec3(-6, 0, 0)), cube, resting());
        CHECK(brackets(toi, 0.5));
        CHECK(toi.normal == Vec3(-1, 0, 0));
        CHECK(toi.gap >= 0);
        CHECK(toi.gap <= 1e-13);
        CHECK(toi.iterations == 0);
    }
    const Motion across = turned(moving(Vec3(0, 0, 6), Vec3(0, 0, -8)), permuting);
    CHECK(brackets(time_of_impact(plank, across, cube, resting()), 0.5625)); // its y points along z: 6 - 1.5
}

TEST_CASE("box-box: an edge on a face, two crossed edges, a corner on a face")
{
    // 45 degrees about z: sqrt 2 from its middle to an edge.
    const Motion on_edge = turned(moving(Vec3(6, 0, 0), Vec3(-8, 0, 0)), eighth);
    const Toi edge = time_of_impact(cube, on_edge, cube, resting());
    CHECK(edge.t == doctest::Approx((5 - std::sqrt(2.0)) / 8).epsilon(1e-14));
    CHECK(edge.t_upper - edge.t < 1e-13);
    // The other one 45 degrees about y: edges along z and y cross at a distance of 2 sqrt 2.
    const Quat about_y(eighth.w(), 0, eighth.z(), 0);
    const Toi crossed = time_of_impact(cube, on_edge, cube, turned(resting(), about_y));
    CHECK(crossed.t == doctest::Approx((6 - 2 * std::sqrt(2.0)) / 8).epsilon(1e-14));
    CHECK(crossed.t_upper - crossed.t < 1e-13);
    CHECK(near(crossed.point_b, Vec3(std::sqrt(2.0), 0, 0)));
    CHECK(near(crossed.normal, Vec3(-1, 0, 0)));
    CHECK(crossed.iterations == 0);
    // Its diagonal (1, 1, 1) along x: sqrt 3 to the corner.
    const double c = std::sqrt(0.5 + 0.5 / std::sqrt(3.0)), s = std::sqrt(0.5 - 0.5 / std::sqrt(3.0));
    const Quat diagonal(c, 0, s * half, -s * half);
    const Motion on_corner = turned(moving(Vec3(6, 0.25, 0.5), Vec3(-8, 0, 0)), diagonal);
    const Toi corner = time_of_impact(cube, on_corner, cube, resting());
    CHECK(corner.t == doctest::Approx((5 - std::sqrt(3.0)) / 8).epsilon(1e-14));
    CHECK(near(corner.point_b, Vec3(1, 0.25, 0.5)));
    CHECK(corner.iterations == 0);
}

TEST_CASE("box-box: walls, needles and points")
{
    const Box wall{Vec3(0, 2, 2)}, needle{Vec3(2, 0, 0)}, point{Vec3(0, 0, 0)};
    CHECK(brackets(time_of_impact(wall, moving(Vec3(3, 0, 0), Vec3(-4, 0, 0)), cube, resting()), 0.5));
    CHECK(brackets(time_of_impact(needle, moving(Vec3(5, 0, 0), Vec3(-4, 0, 0)), cube, resting()), 0.5));
    CHECK(brackets(time_of_impact(point, moving(Vec3(2, 0, 0), Vec3(-2, 0, 0)), cube, resting()), 0.5));
    for (const Box& thin : {wall, needle, point}) {
        const Toi toi = time_of_impact(thin, moving(Vec3(3, 0, 0), Vec3(-6, 0, 0)), point, resting());
        CHECK(toi.status == Status::hit);
        CHECK(toi.t <= (thin.half_extents.x() == 2 ? 1.0 / 6 : 0.5));
        CHECK(toi.t == doctest::Approx(thin.half_extents.x() == 2 ? 1.0 / 6 : 0.5).epsilon(1e-8));
    }
}

TEST_CASE("box-box: past a corner, sliding over a face, resting, apart at the end of the step")
{
    const auto ask = [](const Vec3& from, const Vec3& by, double t_max) {
        return time_of_impact(cube, moving(from, by), cube, resting(), {.t_max = t_max}).status;
    };
    CHECK(ask(Vec3(4, 2.125, 0), Vec3(-8, 0, 0), 1) == Status::separated);
    CHECK(ask(Vec3(4, 2, 0), Vec3(-8, 0, 0), 1) == Status::hit); // faces graze: closed sets touch
    CHECK(ask(Vec3(0, 0, 2), Vec3(1, 0, 0), 1) == Status::touching);
    CHECK(ask(Vec3(0, 0, 2.5), Vec3(5, 3, 0), 1) == Status::separated);
    CHECK(ask(Vec3(5, 0, 0), Vec3(-4, 0, 0), 0.5) == Status::separated);
    CHECK(ask(Vec3(5, 0, 0), Vec3(-4, 0, 0), 0.75) == Status::hit);
    CHECK(ask(Vec3(5, 5, 5), Vec3(-2, -4, -4), 1) == Status::separated);
}

TEST_CASE("box-box: held against advancement and the reference")
{
    const tests::Held held = tests::hold_against_advancement({2, 2}, 20261122, 100'000, 20);
    CHECK(held.hits > 40'000);
    CHECK(held.separated > 20'000);
    CHECK(held.touching > 2'000);
    CHECK(held.close > 100);
    CHECK(held.advanced < 30'000); // those with a target gap among them
    CHECK(held.unproven < 15'000);
}
