// SPDX-License-Identifier: BSD-3-Clause
#include "box_axes.h"
#include "sat.h"
#include "support.h"
#include "support/random.h"

#include <doctest/doctest.h>

using namespace brink;
using support::Random;

namespace {

Core random_box(Random& random, const Rotation& turn, V3 position)
{
    const double x = random.chance(0.1) ? 0 : random.between(0.01, 1), y = random.log_between(1e-3, 2),
                 z = random.between(0.01, 1);
    return placed(core(Box{Vec3(x, y, z)}), turn, position);
}

/// Any, or almost or exactly that of another.
Rotation turned_from(Random& random, const Rotation& other)
{
    const Rotation any = rotation(random.rotation());
    const double angle = random.log_between(1e-12, 1);
    const Rotation nearly = rotation(Quat(1, 0.5 * angle, 0, 0).normalized());
    const int choice = random.index(4);
    return choice == 0 ? other : choice == 1 ? nearly * other : any;
}

} // namespace

TEST_CASE("box_axis: separates whenever the general separating axis test does, by no more than the distance")
{
    Random random(41);
    int apart = 0, edges = 0;
    for (int i = 0; i < 40'000; ++i) {
        const Rotation turn = rotation(random.rotation());
        const Core a = random_box(random, turn, {});
        const Rotation turn_b = turned_from(random, turn);
        const Core b = random_box(random, turn_b, load(random.in_cube(3)));
        const BoxAxis found = box_axis(a, b);
        const Axis best = separating_axis(a, b);
        CAPTURE(i);
        CHECK(gap_along(a, b, found.normal) == doctest::Approx(found.gap).epsilon(1e-9));
        if (best.gap > 1e-5) CHECK(found.gap > 0); // edges nearly parallel are left out
        if (best.gap > 0) CHECK(found.gap <= separation(a, b).gap + 1e-12);
        if (best.gap < -1e-12) CHECK(found.gap < 0);
        apart += found.gap > 0;
        edges += found.index >= 6;
    }
    CHECK(apart > 15'000);
    CHECK(edges > 3'000);
}

TEST_CASE("box_witness: points of both boxes, and as near as the gap where the features face each other")
{
    Random random(42);
    int nearest = 0;
    for (int i = 0; i < 40'000; ++i) {
        const Rotation turn = rotation(random.rotation());
        const Core a = random_box(random, turn, {});
        const Rotation turn_b = turned_from(random, turn);
        const Core b = random_box(random, turn_b, load(random.in_cube(3)));
        const BoxAxis n = box_axis(a, b);
        if (!(n.gap > 0)) continue;
        const BoxWitness w = box_witness(a, b, n.index, n.normal);
        const V3 in_a = into(a.axes, w.point_a - a.centre), in_b = into(b.axes, w.point_a + w.v - b.centre);
        CAPTURE(i);
        for (const auto& [p, h] : {std::pair{in_a, a.half_extents}, std::pair{in_b, b.half_extents}}) {
            CHECK(std::fabs(p.x) <= h.x + 1e-13);
            CHECK(std::fabs(p.y) <= h.y + 1e-13);
            CHECK(std::fabs(p.z) <= h.z + 1e-13);
        }
        CHECK(norm(w.v) >= n.gap - 1e-13);
        nearest += norm(w.v) <= n.gap + 1e-12;
    }
    CHECK(nearest > 5'000);
}
