// SPDX-License-Identifier: BSD-3-Clause
#include "against_advancement.h"
#include "support/moving.h"

using namespace brink;
using support::brackets;
using support::moving;
using support::near;
using support::resting;

namespace {

const Box box{Vec3(1, 2, 3)};
const Capsule upright{Vec3(0, 0, -1), Vec3(0, 0, 1), 0.5}, lying{Vec3(-1, 0, 0), Vec3(1, 0, 0), 0.5};

Toi ask(const Capsule& capsule, const Vec3& from, const Vec3& by)
{
    return time_of_impact(capsule, moving(from, by), box, resting());
}

} // namespace

TEST_CASE("capsule-box: an end and a side meet a face")
{
    const Toi end = ask(lying, Vec3(5.5, 0.5, 1), Vec3(-6, 0, 0)); // 5.5 - 1 - 0.5 - 1 = 3
    CHECK(brackets(end, 0.5));
    CHECK(end.normal == Vec3(-1, 0, 0));
    CHECK(near(end.point_b, Vec3(1, 0.5, 1)));
    const Toi side = ask(upright, Vec3(4.5, -1, 1), Vec3(-6, 0, 0)); // 4.5 - 0.5 - 1 = 3, parallel to it
    CHECK(brackets(side, 0.5));
    CHECK(side.normal == Vec3(-1, 0, 0));
    CHECK(std::fabs(side.point_b.z() - 1) <= 1);
    CHECK(side.iterations == 0);
}

TEST_CASE("capsule-box: edges and corners with round ends and straight sides")
{
    const Capsule thick_upright{Vec3(0, 0, -1), Vec3(0, 0, 1), 5}, ball{Vec3(0, 0, 0), Vec3(0, 0, 0), 7};
    // Side along an edge, 3-4-5 in the plane across: offset (3, 4) from it.
    CHECK(brackets(ask(thick_upright, Vec3(8, 6, 0), Vec3(-8, 0, 0)), 0.5));
    // A ball at a corner, 2-3-6 is 7.
    CHECK(brackets(ask(ball, Vec3(7, 5, 9), Vec3(-8, 0, 0)), 0.5));
    // Crossing the edge along z at (1, 2) at right angles: again 3-4-5, in the plane of x and y turned by the
    // side along (4, -3, 0) / 5 of a capsule that passes over it: distance 5 along (3, 4, 0) / 5.
    const Capsule crossing{Vec3(4, -3, 0), Vec3(-4, 3, 0), 5};
    const Toi crossed = ask(crossing, Vec3(1 + 3 + 4, 2 + 4, 0.5), Vec3(-8, 0, 0));
    CHECK(brackets(crossed, 0.5));
    CHECK(near(crossed.normal, Vec3(-0.6, -0.8, 0)));
    CHECK(near(crossed.point_b, Vec3(1, 2, 0.5)));
}

TEST_CASE("capsule-box: past a corner, inside, sliding along a face, cut by t_max")
{
    CHECK(ask(upright, Vec3(4, 2.5 + 1e-9, 0), Vec3(-8, 0, 0)).status == Status::separated);
    CHECK(ask(upright, Vec3(4, 2.5 - 1e-9, 0), Vec3(-8, 0, 0)).status == Status::hit);
    CHECK(ask(upright, Vec3(4, 0, 4.25), Vec3(-1, 0, 0)).status == Status::separated);
    CHECK(ask(upright, Vec3(0, 0, 0), Vec3(1, 0, 0)).status == Status::touching);
    CHECK(ask(upright, Vec3(0, 0, 4.5 + 1e-6), Vec3(1, 1, 0)).status == Status::separated);
    const Options early{.t_max = 0.25};
    CHECK(time_of_impact(upright, moving(Vec3(4.5, 0, 0), Vec3(-6, 0, 0)), box, resting(), early).status ==
          Status::separated);
}

TEST_CASE("capsule-box: target gap, sides swapped")
{
    const Options gap{.target_gap = 0.25};
    const Toi toi = time_of_impact(lying, moving(Vec3(5.75, 0.5, 1), Vec3(-6, 0, 0)), box, resting(), gap);
    CHECK(brackets(toi, 0.5));
    const Toi other = time_of_impact(box, resting(), lying, moving(Vec3(5.75, 0.5, 1), Vec3(-6, 0, 0)), gap);
    CHECK(other.t == toi.t);
    CHECK(other.normal == -toi.normal);
}

TEST_CASE("capsule-box: held against advancement and the reference")
{
    const tests::Held held = tests::hold_against_advancement({1, 2}, 20261122, 100'000, 20);
    CHECK(held.hits > 35'000);
    CHECK(held.separated > 25'000);
    CHECK(held.touching > 2'000);
    CHECK(held.close > 100);
    CHECK(held.advanced < 20'000); // segments without radius among them
    CHECK(held.unproven < 10'000);
}
