// SPDX-License-Identifier: BSD-3-Clause
#include "polytope.h"
#include "solid_cores.h"

#include <doctest/doctest.h>

using namespace brink;
using support::Random;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

double scale(const Core& a, const Core& b) { return std::max(extent(a), extent(b)); }

/// The largest gap between supporting planes that a search over directions finds.
double best_gap(Random& random, const Core& a, const Core& b, V3 best)
{
    double most = gap_along(a, b, best);
    const auto ask = [&](V3 n) {
        n = (1 / norm(n)) * n;
        const double gap = gap_along(a, b, n);
        if (gap > most) most = gap, best = n;
    };
    for (int i = 0; i < 200; ++i)
        ask(load(random.unit()));
    for (double step = 0.3; step > 1e-9; step *= 0.7)
        for (int i = 0; i < 8; ++i)
            ask(best + step * load(random.unit()));
    return most;
}

/// How far a point is outside of a core, at least.
double outside(Random& random, const Core& c, V3 p)
{
    double most = -infinity;
    for (int i = 0; i < 100; ++i) {
        const V3 n = load(random.unit());
        most = std::max(most, dot(n, p) - interval(c, n).high);
    }
    return most;
}

Core corners_of(const Box& box, std::vector<Hull>& hulls)
{
    std::vector<Vec3> points;
    for (int k = 0; k < 8; ++k)
        points.push_back(store(corner(core(box), k)));
    hulls.push_back(Hull::from_points(points));
    return core(hulls.back());
}

} // namespace

TEST_CASE("cores of every kind: bounds of the gap that agree, and points that show it")
{
    SolidCores cores(81);
    int apart = 0, overlapping = 0, loose = 0;
    for (int i = 0; i < 12'000; ++i) {
        auto [a, b] = cores.pair(i % 5, i / 5 % 8);
        if (i % 2 == 0) b = placed(b, {}, 2.5 * load(cores.random.unit()));
        const Separation s = polytope_separation(a, b);
        const double size = scale(a, b);
        CAPTURE(i);
        CHECK(std::fabs(norm(s.normal) - 1) <= 4 * eps);
        CHECK(std::fabs(s.lower - gap_along(a, b, s.normal)) <= 16 * eps * size);
        CHECK(norm(s.point_b - s.point_a - s.gap * s.normal) <= 64 * eps * size);
        CHECK(s.lower <= s.gap + 4 * eps * size);
        const double truth = best_gap(cores.random, a, b, s.normal);
        CHECK(s.gap >= truth - 1e-9 * size);
        CHECK(s.gap - s.lower <= 1e-3 * size);
        loose += s.gap - s.lower > 1e-9 * size; // needles and rims, whose normals turn at once
        CHECK(outside(cores.random, a, s.point_a) <= 1e-4 * size);
        CHECK(outside(cores.random, b, s.point_b) <= 1e-4 * size);
        apart += s.gap > 0;
        overlapping += s.gap < 0;
    }
    CHECK(loose < 25);
    CHECK(apart > 3'000);
    CHECK(overlapping > 3'000);
}

TEST_CASE("cores that overlap: moved by the gap told along the normal told they are clear")
{
    SolidCores cores(83);
    int overlapping = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto [a, b] = cores.pair(i % 3, i / 3 % 8);
        const Separation s = polytope_separation(a, b);
        if (!(s.gap < -1e-9)) continue;
        CAPTURE(i);
        CHECK(gap_along(a, placed(b, {}, -s.gap * s.normal), s.normal) >= -16 * eps * scale(a, b));
        ++overlapping;
    }
    CHECK(overlapping > 5'000);
}

TEST_CASE("cores apart: a face that is nearly at right angles to the way is the axis of the distance")
{
    // An edge or a corner of it is as near as doubles tell, and leads to an axis that falls short of the
    // distance by the tilt.
    SolidCores cores(103);
    Random& random = cores.random;
    int beside = 0;
    for (int i = 0; i < 4'000; ++i) {
        const double angle = random.log_between(1e-12, 1e-5), gap = random.log_between(1e-3, 1);
        const V3 tilt = angle * load(random.unit());
        const Core box = placed(core(Box{{2, 1.5, 3}}),
                                rotation(Quat(1, 0.5 * tilt.x, 0.5 * tilt.y, 0.5 * tilt.z)), {0, -1.5, 0});
        const Core local = core(cores.hull(4 + random.index(20)));
        const V3 lowest = farthest(local, {0, -1, 0}).point;
        const V3 over{2.0 * (random.index(3) - 1), gap,
                      3.0 * (random.index(3) - 1)}; // the middle or the border
        const Core above = placed(local, {}, over - lowest);
        CAPTURE(i);
        const Separation s = separation(box, above);
        CHECK(s.gap - s.lower <= 1e-9);
        beside += s.gap - s.lower > 64 * eps * scale(box, above);
    }
    CHECK(beside < 20); // of flat hulls, and where other edges count than those of the corners found
}

TEST_CASE("needles that all but touch: bounds of the gap that agree, where so short a way tells no axis")
{
    Random random(107);
    int asked = 0;
    for (int i = 0; i < 6'000; ++i) {
        const auto needle = [&](double width, int count) {
            std::vector<Vec3> points;
            for (int k = 0; k < count; ++k) {
                const Vec3 p = random.in_cube(1);
                points.emplace_back(p.x(), width * p.y(), width * p.z());
            }
            return Hull::from_points(points);
        };
        const double width = random.log_between(1e-9, 1), length = random.between(0, 1);
        const int count = 4 + random.index(6), other_count = 4 + random.index(6);
        const Hull thin = needle(random.log_between(1e-7, 1e-2), count), other = needle(width, other_count);
        const Core bar = core(Box{{length, width, width}});
        const Core local = i % 3 == 0 ? bar : core(other);
        const Quat turned = random.rotation(), other_turned = random.rotation();
        const Core a = placed(core(thin), rotation(turned), {});
        Core b = placed(local, rotation(other_turned), load(random.in_cube(1)));
        const double gap = random.log_between(1e-13, 1e-4);
        for (int k = 0; k < 4; ++k) {
            const Separation s = separation(a, b);
            b = placed(b, {}, (gap - s.gap) * s.normal);
        }
        const Separation s = separation(a, b);
        const double size = scale(a, b);
        if (!(s.gap > 8 * eps * size)) continue;
        CAPTURE(i);
        CHECK(s.gap - s.lower <= 16 * eps * size);
        CHECK(std::fabs(s.lower - gap_along(a, b, s.normal)) <= 16 * eps * size);
        CHECK(norm(s.point_b - s.point_a - s.gap * s.normal) <= 64 * eps * size);
        ++asked;
    }
    CHECK(asked > 5'000);
}

TEST_CASE("a ball as ellipsoid, a box as hull: the same as themselves")
{
    Random random(82);
    std::vector<Hull> hulls;
    hulls.reserve(20'000);
    int apart = 0, overlapping = 0;
    for (int i = 0; i < 4'000; ++i) {
        const double r = random.between(0, 1), x = random.between(0, 1), y = random.between(0, 1);
        const double z = random.chance(0.2) ? 0 : random.between(0, 1);
        const Quat q = random.rotation(), o = random.rotation();
        const V3 at = random.between(0, 2) * load(random.unit());
        const Box box{{x, y, z}}, other{{z, y, 0.5}};
        const Core ball = core(Sphere{r}), round = core(Ellipsoid{{r, r, r}});
        const Core placed_box = placed(core(box), rotation(q), at),
                   placed_hull = placed(corners_of(box, hulls), rotation(q), at);
        const Separation true_ball = separation(ball, placed_box),
                         as_ellipsoid = separation(round, placed_box);
        CAPTURE(i);
        CHECK(std::fabs(true_ball.gap - as_ellipsoid.gap) <= 1e-9);
        const Core a = placed(core(other), rotation(o), {}),
                   as_hull = placed(corners_of(other, hulls), rotation(o), {});
        const double gap = separation(a, placed_box).gap;
        CHECK(std::fabs(separation(a, placed_hull).gap - gap) <= 64 * eps);
        CHECK(std::fabs(separation(as_hull, placed_hull).gap - gap) <= 64 * eps);
        apart += gap > 0;
        overlapping += gap < 0;
    }
    CHECK(apart > 1'000);
    CHECK(overlapping > 1'000);
}
