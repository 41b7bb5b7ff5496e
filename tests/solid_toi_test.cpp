// SPDX-License-Identifier: BSD-3-Clause
#include "draw.h"
#include "print.h"

#include <brink/distance.h>
#include <doctest/doctest.h>

#include <algorithm>

using namespace brink;
using support::Random;

namespace {

/// Two bodies on their way past each other, one shape of the two a cylinder, a cone, an ellipsoid or a hull.
support::Query encounter(Random& random, std::size_t first, std::size_t second)
{
    support::Query q{support::draw_shape(random, first, support::ShapeStyle::any),
                     {},
                     support::draw_shape(random, second, support::ShapeStyle::any),
                     {},
                     {}};
    const Quat turn_a = support::draw_orientation(random), turn_b = support::draw_orientation(random);
    const Vec3 from = random.between(0.5, 4) * random.unit(), aim = random.in_cube(1);
    q.motion_a = {{from, turn_a}, aim - from};
    q.motion_b.start = {random.in_cube(0.1), turn_b};
    if (random.chance(0.5)) q.motion_a.rotation = random.in_cube(2);
    if (random.chance(0.5)) q.motion_b.rotation = random.in_cube(4);
    q.motion_a.translation *= random.between(0.5, 2);
    return q;
}

double gap(const support::Query& q, double t)
{
    return distance(q.a, q.motion_a.at(t), q.b, q.motion_b.at(t)).gap;
}

} // namespace

TEST_CASE("time_of_impact: cylinders, cones, ellipsoids and hulls against every shape, apart until t")
{
    Random random(131);
    int hits = 0, separated = 0, touching = 0, undecided = 0, asked = 0;
    for (int i = 0; i < 8'000; ++i) {
        const auto first = static_cast<std::size_t>(i % 10),
                   second = 6 + static_cast<std::size_t>(i / 10 % 4);
        const support::Query q = encounter(random, first, second);
        const Toi toi = support::answer(q);
        CAPTURE(i);
        ++asked;
        hits += toi.status == Status::hit;
        separated += toi.status == Status::separated;
        touching += toi.status == Status::touching;
        undecided += toi.status == Status::undecided;
        REQUIRE(toi.status != Status::invalid);
        if (toi.status == Status::touching) {
            CHECK(gap(q, 0) <= 1e-12);
            continue;
        }
        double least = infinity;
        for (int k = 0; k <= 32; ++k)
            least = std::min(least, gap(q, toi.t * k / 32));
        CHECK(least > -1e-12);
        if (toi.status == Status::hit) CHECK(gap(q, toi.t) <= 1e-8);
    }
    CHECK(hits > asked / 5);
    CHECK(separated > asked / 5);
    CHECK(touching > asked / 20);
    CHECK(undecided < asked / 1000);
}
