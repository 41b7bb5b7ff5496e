// SPDX-License-Identifier: BSD-3-Clause
#include "round_axis.h"
#include "solid_cores.h"

#include <doctest/doctest.h>

using namespace brink;
using support::Random;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

V3 tilted(Random& random, V3 axis, double angle)
{
    const V3 n = axis + angle * load(random.unit());
    return (1 / norm(n)) * n;
}

} // namespace

TEST_CASE("locally best axis: that of two balls, apart and overlapping")
{
    Random random(141);
    for (int i = 0; i < 2'000; ++i) {
        const double r = random.between(0.1, 1), s = random.between(0.1, 1), apart = random.between(0.2, 3);
        const V3 way = load(random.unit());
        const Core a = core(Ellipsoid{{r, r, r}}), b = placed(core(Ellipsoid{{s, s, s}}), {}, apart * way);
        const V3 start = tilted(random, way, random.log_between(1e-9, 0.2));
        const LocalTop found = locally_best(a, b, {gap_along(a, b, start), start}, 32 * eps);
        CAPTURE(i);
        CHECK(found.top);
        CHECK(std::fabs(found.axis.gap - (apart - r - s)) <= 64 * eps);
        CHECK(norm(found.axis.normal - way) <= 1e-7);
        CHECK(norm(found.v - found.axis.gap * found.axis.normal) <= 1e-7);
    }
}

TEST_CASE("locally best axis: upright on the ridge where two cylinders cross, side against side")
{
    Random random(142);
    for (int i = 0; i < 1'000; ++i) {
        const double gap = random.between(-0.2, 0.5), angle = random.between(0.2, 1.4);
        const Quat lying(std::cos(angle), std::sin(angle), 0, 0); // about x
        const Core a = core(Cylinder{2, 0.5});
        const Core b = placed(core(Cylinder{2, 0.25}), rotation(lying), {0.75 + gap, 0, 0});
        const V3 start = tilted(random, {1, 0, 0}, random.log_between(1e-9, 1e-7));
        const LocalTop found = locally_best(a, b, {gap_along(a, b, start), start}, 32 * eps);
        CAPTURE(i);
        CHECK(found.axis.gap <= gap + 8 * eps);
        CHECK(found.axis.gap >= gap - 32 * eps);
        CHECK(found.top);
    }
}

TEST_CASE("locally best axis: on the ridge where a cone's side lies against the plane")
{
    // A segment from the cone's axis outwards: all axes that lean on the side away from it are as good.
    Random random(145);
    for (int i = 0; i < 2'000; ++i) {
        const double h = random.between(0.2, 2), r = random.between(0.2, 2),
                     z = random.between(-0.5, 0.5) * h;
        const Core a = core(Capsule{{0, 0, z}, {0, 4, z}, 0}), b = core(Cone{h, r});
        const double slant = std::sqrt(r * r + 4 * h * h), turn = random.between(0.2, 2.9);
        const V3 side{-2 * h / slant * std::cos(turn), -2 * h / slant * std::sin(turn), -r / slant};
        const V3 start = tilted(random, side, random.log_between(1e-9, 1e-3));
        const LocalTop found = locally_best(a, b, {gap_along(a, b, start), start}, 32 * eps);
        CAPTURE(i);
        CHECK(std::fabs(found.axis.gap + (h - z) * r / slant) <= 32 * eps);
        CHECK(found.top);
    }
}

TEST_CASE("locally best axis: never worse than the one given, whatever the cores")
{
    SolidCores cores(143);
    int better = 0;
    for (int i = 0; i < 4'000; ++i) {
        const auto [a, b] = cores.pair(i % 3, i / 3 % 8);
        const V3 start = load(cores.random.unit());
        const double size = std::max(extent(a), extent(b)), slack = 8 * eps * size;
        const LocalTop found = locally_best(a, b, {gap_along(a, b, start), start}, slack);
        CAPTURE(i);
        CHECK(found.axis.gap >= gap_along(a, b, start) - slack);
        CHECK(found.axis.gap == gap_along(a, b, found.axis.normal));
        better += found.axis.gap > gap_along(a, b, start) + 1e-3 * size;
    }
    CHECK(better > 3'500);
}

TEST_CASE(
    "locally best axis: round cores about to touch are told to a few roundings, edges and generators too")
{
    SolidCores cores(144);
    int asked = 0, wide = 0;
    for (int i = 0; i < 12'000; ++i) {
        auto [a, b] = cores.pair(i % 3, i / 3 % 8);
        b = placed(b, {}, 8 * load(cores.random.unit()));
        for (const double apart : {1e-6, cores.random.log_between(1e-14, 1e-10)}) {
            const Separation s = separation(a, b);
            b = placed(b, {}, (apart - s.gap) * s.normal);
        }
        const Separation s = separation(a, b);
        if (!(s.gap > 0)) continue;
        ++asked;
        wide += s.gap - gap_along(a, b, s.normal) > 64 * eps * (reach(a) + reach(b));
    }
    CAPTURE(wide);
    CHECK(asked > 11'000);
    CHECK(wide < asked / 200);
}

TEST_CASE(
    "nearly best axis: of an ellipsoid apart from what has no faces, as nearly as asked, from one beside")
{
    Random random(146);
    int found = 0, asked = 0;
    for (int i = 0; i < 6'000; ++i) {
        const auto radius = [&] { return random.log_between(0.1, 1); };
        const double x = radius(), y = radius(), z = radius();
        const Core a = placed(core(Ellipsoid{{x, y, z}}), rotation(random.rotation()), {});
        const Core others[] = {core(Sphere{0.1}), core(Capsule{{0, 0, -x}, {0, 0, y}, 0}),
                               core(Ellipsoid{{z, x, y}}), core(Cylinder{x, y}), core(Cone{y, z})};
        const Core b =
            placed(others[i % 5], rotation(random.rotation()), random.between(0.5, 4) * load(random.unit()));
        const Separation s = separation(a, b);
        const double gap = s.gap + b.radius;
        CAPTURE(i);
        const V3 start = tilted(random, s.normal, random.log_between(1e-6, 0.3));
        const LocalTop top = nearly_best(a, b, start, {8 * eps, 1e-4, 0.5 * gap});
        if (gap < -1e-9) CHECK(!top.top);
        if (!(gap > 1e-3)) continue;
        ++asked;
        if (!top.top) continue;
        ++found;
        CHECK(std::fabs(top.axis.gap - gap_along(a, b, top.axis.normal)) <= 16 * eps);
        CHECK(norm(top.v) - top.axis.gap <= 8 * eps + 1e-4 * (norm(top.v) - 0.5 * gap));
        CHECK(top.axis.gap <= gap + 32 * eps);
        Core on_a, on_b; // points of the cores
        on_a.points[0] = top.point_a, on_b.points[0] = top.point_a + top.v;
        CHECK(separation(on_a, a).gap <= 32 * eps);
        CHECK(separation(on_b, b).gap + b.radius <= 32 * eps);
    }
    CAPTURE(found);
    CHECK(asked > 3'000);
    CHECK(found > 0.8 * asked);
}
