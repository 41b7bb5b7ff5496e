// SPDX-License-Identifier: BSD-3-Clause
#include "brute_force.h"
#include "sat.h"

#include <doctest/doctest.h>

using namespace brink;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

Core segment(V3 a, V3 b) { return core(Capsule{store(a), store(b), 0}); }
Core triangle(V3 a, V3 b, V3 c) { return core(Triangle{store(a), store(b), store(c)}); }
Core at(Core c, V3 position) { return placed(c, {}, position); }

} // namespace

TEST_CASE("sat: boxes by hand")
{
    const Core box = core(Box{{1, 2, 3}});
    const Axis x = separating_axis(box, at(box, {-1.5, 0, 0}));
    CHECK(x.gap == -0.5);
    CHECK(x.normal == V3{-1, 0, 0});
    CHECK(separating_axis(box, at(box, {0, 5, 0})).gap == 1);
    CHECK(separating_axis(box, box).gap == -2);
}

TEST_CASE("sat: two crossing edges")
{
    // Edge along x at height 1 over one along y at height 0, both with body below and above them.
    const Core lower = triangle({0, -2, 0}, {0, 2, 0}, {0, 0, -8});
    const Core upper = triangle({-2, 0, 0}, {2, 0, 0}, {0, 0, 8});
    const Axis apart = separating_axis(lower, at(upper, {0, 0, 0.5}));
    CHECK(apart.gap == 0.5);
    CHECK(apart.normal == V3{0, 0, 1});
    const Axis sunk = separating_axis(lower, at(upper, {0, 0, -0.25}));
    CHECK(sunk.gap == -0.25);
    CHECK(sunk.normal == V3{0, 0, 1});
}

TEST_CASE("sat: flat pairs have depth 0 across them")
{
    const Core t = triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
    const Core collinear = triangle({0, 0, 0}, {1, 1, 1}, {3, 3, 3});
    const Core flat = core(Box{{1, 1, 0}});
    CHECK(separating_axis(t, at(t, {1, 1, 0})).gap == 0);
    CHECK(separating_axis(t, t).normal == V3{0, 0, 1});
    CHECK(separating_axis(flat, t).gap == 0);
    CHECK(separating_axis(segment({-1, 0, 0}, {1, 0, 0}), segment({0, -1, 0}, {0, 1, 0})).gap == 0);
    CHECK(std::fabs(
              separating_axis(segment({-1, 0, 0}, {1, 0, 0}), segment({0, -1, 0}, {0, 1, 0})).normal.z) == 1);
    CHECK(std::fabs(separating_axis(segment({0, 0, 0}, {2, 2, 2}), collinear).gap) <= eps);
    CHECK(std::fabs(separating_axis(core(Box{}), at(segment({-1, -2, -3}, {1, 2, 3}), {})).gap) <= eps);
    CHECK(norm(separating_axis(core(Sphere{}), core(Sphere{})).normal) == 1);
}

TEST_CASE("sat: no direction gives less depth, and moving B out by it leaves the two touching")
{
    NastyCores cores(41);
    const Core::Kind kinds[] = {Core::Kind::segment, Core::Kind::triangle, Core::Kind::box};
    int overlapping = 0, deep = 0;
    for (int i = 0; i < 12'000; ++i) {
        const auto [a, b] = cores.pair(kinds[i % 3], kinds[i / 3 % 3]);
        const Axis axis = separating_axis(a, b);
        CAPTURE(i);
        CHECK(std::fabs(norm(axis.normal) - 1) <= 4 * eps);
        if (brute::distance(a, b) > 0) continue;
        const double rounding = 32 * eps * brute::scale(a, b);
        const auto p = brute::polytope(a), q = brute::polytope(b);
        for (int k = 0; k < 100; ++k) {
            const V3 n = load(cores.random.unit());
            CHECK(static_cast<double>(brute::along(p, q, brute::real(n))) <= axis.gap + rounding);
        }
        if (axis.gap > -1e-6 || brute::scale(a, b) > 100) continue;
        const Core out = at(b, (1e-9 - axis.gap) * axis.normal), in = at(b, (-1e-9 - axis.gap) * axis.normal);
        CHECK(std::fabs(brute::distance(a, out) - 1e-9) <= 1e-12);
        CHECK(brute::distance(a, in) < 0);
        ++overlapping;
        deep += axis.gap < -0.01;
    }
    CHECK(overlapping > 400);
    CHECK(deep > 250);
}

TEST_CASE("sat: as deep as by brute force, boxes all but parallel")
{
    support::Random random(17);
    int overlapping = 0;
    for (int i = 0; i < 4'000; ++i) {
        const Vec3 h = random.in_cube(1), g = random.in_cube(1), p = random.in_cube(1), axis = random.unit();
        const double angle = random.log_between(1e-17, 1e-1);
        const Core a = core(Box{h.cwiseAbs()}), b = core(Box{g.cwiseAbs()});
        const Core turned =
            placed(b, rotation({1, angle * axis.x(), angle * axis.y(), angle * axis.z()}), load(p));
        const double gap = separating_axis(a, turned).gap;
        const double truth = brute::distance(a, turned);
        CAPTURE(i);
        CHECK(gap <= truth + 32 * eps);
        if (truth < 0) CHECK(gap >= truth - 32 * eps);
        overlapping += gap < 0;
    }
    CHECK(overlapping > 1'000);
}
