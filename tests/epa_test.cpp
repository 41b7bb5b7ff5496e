// SPDX-License-Identifier: BSD-3-Clause
#include "brute_force.h"
#include "epa.h"
#include "sat.h"
#include "solid_cores.h"

#include <doctest/doctest.h>

using namespace brink;
using support::Random;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

double slack(const Core& a, const Core& b) { return 8 * eps * std::max(extent(a), extent(b)); }

/// The largest gap between supporting planes that a search over directions finds: minus the depth.
double best_gap(Random& random, const Core& a, const Core& b, V3 start)
{
    V3 best = start;
    double most = gap_along(a, b, best);
    const auto ask = [&](V3 n) {
        n = (1 / norm(n)) * n;
        const double gap = gap_along(a, b, n);
        if (gap > most) most = gap, best = n;
    };
    for (int i = 0; i < 300; ++i)
        ask(load(random.unit()));
    for (double step = 0.3; step > 1e-9; step *= 0.7)
        for (int i = 0; i < 8; ++i)
            ask(best + step * load(random.unit()));
    return most;
}

} // namespace

TEST_CASE("epa: as deep as separating axes find it, boxes and triangles")
{
    NastyCores cores(71);
    const Core::Kind kinds[] = {Core::Kind::segment, Core::Kind::triangle, Core::Kind::box};
    int overlapping = 0, exact = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto [a, b] = cores.pair(kinds[i % 3], kinds[i / 3 % 3]);
        const Axis axis = separating_axis(a, b);
        if (!(axis.gap < 0)) continue;
        const Penetration p = penetration(a, b, slack(a, b));
        const double rounding = 32 * eps * brute::scale(a, b);
        CAPTURE(i);
        CHECK(std::fabs(p.lower - axis.gap) <= rounding);
        CHECK(std::fabs(p.gap - axis.gap) <= rounding);
        CHECK(std::fabs(norm(p.normal) - 1) <= 4 * eps);
        const double off = norm(p.v - p.gap * p.normal);
        CHECK(off <= 1e-3 * brute::scale(a, b)); // the place in a face that is a needle
        exact += off <= rounding;
        ++overlapping;
    }
    CHECK(exact > 0.95 * overlapping);
    CHECK(overlapping > 2'000);
}

TEST_CASE("epa: balls in the guise of ellipsoids")
{
    Random random(72);
    for (int i = 0; i < 2'000; ++i) {
        const double r = random.between(0.1, 2), s = random.between(0.1, 2);
        const double apart = random.between(0, 0.99) * (r + s);
        const V3 way = load(random.unit());
        const Core a = core(Ellipsoid{{r, r, r}}), b = placed(core(Ellipsoid{{s, s, s}}), {}, apart * way);
        const Penetration p = penetration(a, b, slack(a, b));
        CAPTURE(i);
        CHECK(std::fabs(p.lower - (apart - r - s)) <= 1e-9 * (r + s));
        CHECK(p.gap - p.lower <= 1e-9 * (r + s));
        CHECK(p.gap >= p.lower);
        if (apart > 0.05) CHECK(norm(p.normal - way) <= 1e-4 / apart);
    }
}

TEST_CASE("epa: a cone that a segment enters as far as its axis is as deep in many directions")
{
    Random random(74);
    for (int i = 0; i < 1'000; ++i) {
        const double h = random.between(0.2, 2), r = random.between(0.2, 2), z = random.between(0, 1) * h;
        const Quat turned = random.rotation();
        const V3 at = load(random.in_cube(1));
        const Core a = placed(core(Capsule{{0, 0, z}, {3, 4, z}, 0}), rotation(turned), at);
        const Core b = placed(core(Cone{h, r}), rotation(turned), at);
        const double depth = (h - z) * r / std::sqrt(r * r + 4 * h * h);
        const Penetration p = penetration(a, b, slack(a, b));
        CAPTURE(i);
        CHECK(std::fabs(p.lower + depth) <= 64 * eps * brute::scale(a, b));
        CHECK(std::fabs(p.gap + depth) <= 64 * eps * brute::scale(a, b));
    }
}

TEST_CASE("epa: no direction gives less depth, cylinders, cones, ellipsoids and hulls")
{
    SolidCores cores(73);
    int overlapping = 0, deep = 0, loose = 0;
    for (int i = 0; i < 6'000; ++i) {
        const auto [a, b] = cores.pair(i % 5, i / 5 % 8);
        const double scale = std::max(extent(a), extent(b));
        const Penetration p = penetration(a, b, slack(a, b));
        CAPTURE(i);
        CHECK(std::fabs(norm(p.normal) - 1) <= 4 * eps);
        CHECK(std::fabs(p.lower - gap_along(a, b, p.normal)) <= 8 * eps * scale);
        if (p.lower > 0) continue;
        CHECK(p.gap >= p.lower);
        const double truth = best_gap(cores.random, a, b, p.normal);
        CHECK(p.lower <= truth);
        CHECK(truth - p.lower <= 1e-3 * scale);
        loose += truth - p.lower > 1e-9 * scale; // the room ran out, or long cylinders lie side by side
        ++overlapping;
        deep += p.lower < -0.01;
    }
    CHECK(loose <= 5);
    CHECK(overlapping > 2'000);
    CHECK(deep > 1'500);
}
