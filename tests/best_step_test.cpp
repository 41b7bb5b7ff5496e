// SPDX-License-Identifier: BSD-3-Clause
#include "best_step.h"
#include "two_bodies.h"
#include "window.h"

#include <doctest/doctest.h>

using namespace brink;
using support::Random;

TEST_CASE(
    "rolling: the spin of a normal that turns at a constant rate, and none from a normal that stands still")
{
    Random random(151);
    for (int i = 0; i < 1'000; ++i) {
        const V3 first = load(random.unit()), across = any_perpendicular(first);
        const double rate = random.log_between(1e-2, 10), time = random.between(0, 0.5), step = 1e-4;
        const SinCos at = sin_cos(rate * step);
        Rolling rolling;
        rolling.see(first, time);
        CHECK(rolling.spin == V3{});
        rolling.see(first, time + step);
        CHECK(rolling.spin == V3{});
        rolling.see(at.cos * first + at.sin * across, time + step);
        const V3 truth = rate * cross(first, across);
        CAPTURE(i);
        CHECK(norm(rolling.spin - truth) <= 1e-6 * rate);
        rolling.see(first, time + step); // no time has passed
        CHECK(norm(rolling.spin - truth) <= 1e-6 * rate);
    }
}

TEST_CASE("step_at_hand: nothing opens into contact, the plane turns or not")
{
    Random random(153);
    int certified = 0, of_planes = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Motion motion_a = random_motion(random, 2), motion_b = random_motion(random, 2);
        const Mover<Core> a = moving_core(random_shape(random, i % 8), motion_a);
        const double t = random.between(0, 0.9);
        const auto check = [&](const auto& scene, int& count) {
            const Separation now = scene.at(t);
            const Moment s(scene, t);
            const auto f = s.facing();
            const AtHand step = step_at_hand(f, {now.normal, 0.1}, {now.normal, f.b.rate}, 1 - t);
            if (!(now.gap > 1e-9)) return;
            CAPTURE(i);
            CHECK(least_gap(scene, t, step.length) > -1e-12);
            ++count;
        };
        check(TwoBodies<Core>{a, moving_core(random_shape(random, i / 8 % 8), motion_b)}, certified);
        check(TwoBodies<Border>{a, mover(HalfSpace{random.unit(), 0}, motion_b)}, of_planes);
    }
    CHECK(certified > 5'000);
    CHECK(of_planes > 5'000);
}

TEST_CASE("never_near: balls that pass by a hair, that hold bodies however they turn")
{
    Random random(152);
    for (int i = 0; i < 2'000; ++i) {
        const double x = random.between(0.1, 1), y = random.between(0.1, 1), z = random.between(0.1, 1);
        const Core a = core(Box{{x, y, z}}), b = core(Sphere{random.between(0.1, 1)});
        Options options;
        options.target_gap = random.chance(0.5) ? random.between(0, 1) : 0;
        const double together = std::sqrt(x * x + y * y + z * z) + b.radius + options.target_gap;
        const Vec3 way = random.unit(), side = Vec3(way.unitOrthogonal());
        const double before = random.between(2, 5) * together;
        Motion still{Pose{random.in_cube(3), random.rotation()}}, moving{Pose{{}, random.rotation()}};
        moving.rotation = still.rotation = random.in_cube(3);
        moving.translation = 2 * before * way;
        const auto passes_at = [&](double distance) {
            moving.start.position = still.start.position - before * way + distance * side;
            return never_near(reach(a) + b.radius, still, moving, options);
        };
        CAPTURE(i);
        CHECK(passes_at(together * (1 + 1e-9)));
        CHECK(!passes_at(together * (1 - 1e-9)));
        CHECK(!passes_at(0));
        options.t_max = 0.5 * (1 - together / before) - 1e-9; // they meet after it
        CHECK(passes_at(0));
        options.t_max += 2e-9;
        CHECK(!passes_at(0));
        still.pivot = Vec3(0, 0, 1); // another way round: not told here
        CHECK(!passes_at(together * 2));
    }
}
