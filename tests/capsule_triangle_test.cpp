// SPDX-License-Identifier: BSD-3-Clause
#include "against_advancement.h"
#include "support/moving.h"

using namespace brink;
using support::brackets;
using support::moving;
using support::near;
using support::resting;

namespace {

const Triangle triangle{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
const Capsule upright{Vec3(0, 0, -1), Vec3(0, 0, 1), 0.5}, lying{Vec3(-0.5, 0, 0), Vec3(0.5, 0, 0), 0.5};

Toi ask(const Capsule& capsule, const Vec3& from, const Vec3& by)
{
    return time_of_impact(capsule, moving(from, by), triangle, resting());
}

} // namespace

TEST_CASE("capsule-triangle: an end and a side meet the face, from both sides")
{
    for (const double side : {1.0, -1.0}) {
        const Toi end = ask(upright, Vec3(1, 1, 4.5 * side), Vec3(0, 0, -6 * side));
        CHECK(brackets(end, 0.5));
        CHECK(near(end.normal, Vec3(0, 0, -side)));
        CHECK(near(end.point_b, Vec3(1, 1, 0)));
        CHECK(brackets(ask(lying, Vec3(1, 1, 3.5 * side), Vec3(0, 0, -6 * side)), 0.5));
    }
}

TEST_CASE("capsule-triangle: edges and corners")
{
    // Upright past the edge along x: radius 0.5, the edge 3.5 away.
    const Toi across = ask(upright, Vec3(2, -3.5, 0), Vec3(0, 6, 0));
    CHECK(brackets(across, 0.5));
    CHECK(near(across.point_b, Vec3(2, 0, 0)));
    // A round end at the corner (4, 0, 0): 2-3-6 is 7.
    const Capsule big{Vec3(0, 0, 0), Vec3(0, 0, 5), 7};
    CHECK(brackets(ask(big, Vec3(14, -3, 2), Vec3(-8, 0, 0)), 0.5));
    // In the plane of the triangle, lying along its edge: a side against an edge.
    CHECK(brackets(ask(lying, Vec3(2, -3.5, 0), Vec3(0, 6, 0)), 0.5));
}

TEST_CASE("capsule-triangle: degenerate triangles and a capsule that is a ball")
{
    const Triangle needle{Vec3(0, 0, -4), Vec3(0, 0, 4), Vec3(0, 0, 1)}, point{};
    const Capsule ball{Vec3(0, 0, 0), Vec3(0, 0, 0), 1};
    const Motion along_x = moving(Vec3(4, 0, 0), Vec3(-6, 0, 0));
    CHECK(brackets(time_of_impact(ball, along_x, needle, resting()), 0.5));
    CHECK(brackets(time_of_impact(ball, along_x, point, resting()), 0.5));
    CHECK(brackets(time_of_impact(upright, moving(Vec3(3.5, 0, 0), Vec3(-6, 0, 0)), needle, resting()), 0.5));
    CHECK(ask(ball, Vec3(3, 3, 0), Vec3(0, 0, 1)).status == Status::separated);
}

TEST_CASE("capsule-triangle: pierced at the start, past a corner")
{
    CHECK(ask(upright, Vec3(1, 1, 0), Vec3(1, 0, 0)).status == Status::touching);
    const Capsule thin{Vec3(0, 0, -9), Vec3(0, 0, 9), 1e-3};
    CHECK(ask(thin, Vec3(1, 1, 0), Vec3(9, 0, 0)).status == Status::touching); // far from every edge
    CHECK(ask(upright, Vec3(4.5 + 1e-9, -4, 0), Vec3(0, 8, 0)).status == Status::separated);
}

TEST_CASE("capsule-triangle: held against advancement and the reference")
{
    const tests::Held held = tests::hold_against_advancement({1, 3}, 20261122, 100'000, 20);
    CHECK(held.hits > 25'000);
    CHECK(held.separated > 40'000);
    CHECK(held.touching > 2'000);
    CHECK(held.close > 100);
    CHECK(held.advanced < 25'000);
    CHECK(held.unproven < 10'000);
}
