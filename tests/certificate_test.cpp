// SPDX-License-Identifier: BSD-3-Clause
#include "certificate.h"
#include "support.h"
#include "two_bodies.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace brink;
using support::Random;

TEST_CASE("safe_step: no gap opens into contact within a certified step, whatever the axis and its spin")
{
    Random random(11);
    int certified = 0, whole = 0;
    for (int i = 0; i < 40'000; ++i) {
        const auto [scene, t, axis] = any_moment(random, i);
        const Moment<Core> s(scene, t);
        const double horizon = 1 - t;
        const Step step = safe_step(s.facing(), axis, horizon);
        if (!(step.gap > 1e-9)) continue;
        CAPTURE(i);
        CHECK(step.length > 0);
        CHECK(step.length <= horizon);
        CHECK(least_gap(scene, t, step.length) > -1e-12);
        ++certified;
        whole += step.length == horizon;
    }
    CHECK(certified > 10'000);
    CHECK(whole > 200);
    CHECK(whole < certified - 4'000);
}

TEST_CASE("safe_step: the gap along the axis itself, which turns, is not negative within it")
{
    Random random(15);
    int certified = 0;
    double least_left = infinity;
    for (int i = 0; i < 100'000; ++i) {
        const Box a = random_box(random), b = random_box(random);
        const TwoBodies<Core> scene{mover(a, random_motion(random, 3)), mover(b, random_motion(random, 3))};
        const double t = random.between(0, 0.9);
        const Moment<Core> s(scene, t);
        const V3 spin = any_spin(random, scene), across = s.b.centre - s.a.centre;
        const V3 normal = random.chance(0.5) ? scene.at(t).normal : (1 / norm(across)) * across;
        const Step step = safe_step(s.facing(), TurningAxis{normal, spin}, 1 - t);
        if (!(step.gap > 1e-9)) continue;
        CAPTURE(i);
        ++certified;
        const double rate = norm(spin);
        const Turn turn = rate > 0 ? Turn{spin, (1 / rate) * spin, rate} : Turn{};
        double least = infinity;
        for (int k = 1; k <= 32; ++k) {
            const double h = step.length * k / 32;
            const Moment<Core> then(scene, t + h);
            least = std::min(least, gap_along(then.a, then.b, turned(turn, h) * normal));
        }
        CHECK(least > -1e-12);
        if (step.length < 1 - t) least_left = std::min(least_left, least / step.gap);
    }
    CHECK(certified > 30'000);
    CHECK(least_left < 1e-6); // what is proven of some is all that is true
}

TEST_CASE("rising_step: the gap stays at or above where it was")
{
    Random random(12);
    int rising = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Box a = random_box(random), b = random_box(random);
        const Motion motion_a = random_motion(random, 1.5), motion_b = random_motion(random, 1.5);
        const TwoBodies<Core> scene{mover(a, motion_a), mover(b, motion_b)};
        const double t = random.between(0, 0.9);
        const Moment<Core> s(scene, t);
        const Separation now = scene.at(t);
        const V3 spin = any_spin(random, scene);
        const double step = rising_step(s.facing(), TurningAxis{now.normal, spin}, 1 - t);
        if (step == 0) continue;
        CAPTURE(i);
        double least = infinity;
        for (int k = 0; k <= 64; ++k)
            least = std::min(least, scene.at(t + step * k / 64).gap);
        CHECK(least > now.lower - 1e-12);
        ++rising;
    }
    CHECK(rising > 2'000);
    CHECK(rising < 17'000);
}

TEST_CASE("growing_step: the distance of cores does not decrease at any moment")
{
    Random random(14);
    int growing = 0, worthwhile = 0;
    for (int i = 0; i < 40'000; ++i) {
        const auto [scene, t, axis] = any_moment(random, i);
        const Moment<Core> s(scene, t);
        const Separation now = scene.at(t);
        const double step = growing_step(s.facing(), axis, now, 1 - t);
        if (step == 0) continue;
        CAPTURE(i);
        CHECK(step <= 1 - t);
        CHECK(now.gap > 0);
        double last = -infinity, most_fallen = 0;
        for (int k = 0; k <= 256; ++k) {
            const double gap = scene.at(t + step * k / 256).gap;
            most_fallen = std::max(most_fallen, last - gap);
            last = gap;
        }
        CHECK(most_fallen < 1e-9); // what the distance of curved cores is known to
        ++growing;
        worthwhile += step > 0.1 * rising_step(s.facing(), axis, 1 - t);
    }
    CHECK(growing > 4'000);
    CHECK(worthwhile > growing / 4);
}

TEST_CASE("growing_step: the gap to a plane or half-space does not decrease at any moment")
{
    Random random(13);
    int growing = 0, worthwhile = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Shape shape = random_shape(random, i % 8);
        const Motion motion_a = random_motion(random, 1.5), motion_b = random_motion(random, 1.5);
        const Vec3 normal = random.unit();
        const Mover<Border> border =
            i % 16 < 8 ? mover(Plane{normal, 0}, motion_b) : mover(HalfSpace{normal, 0}, motion_b);
        const TwoBodies<Border> scene{moving_core(shape, motion_a), border};
        const double t = random.between(0, 0.9);
        const Moment<Border> s(scene, t);
        const TurningAxis axis{scene.at(t).normal, scene.b.turn.rate};
        const double step = growing_step(s.facing(), axis, 1 - t);
        if (step == 0) continue;
        CAPTURE(i);
        CHECK(step <= 1 - t);
        double last = -infinity, most_fallen = 0;
        for (int k = 0; k <= 256; ++k) {
            const double gap = scene.at(t + step * k / 256).gap;
            most_fallen = std::max(most_fallen, last - gap);
            last = gap;
        }
        CHECK(most_fallen < 1e-13);
        ++growing;
        worthwhile += step > 0.1 * rising_step(s.facing(), axis, 1 - t);
    }
    CHECK(growing > 2'000);
    CHECK(growing < 17'000);
    CHECK(worthwhile > growing / 2);
}
