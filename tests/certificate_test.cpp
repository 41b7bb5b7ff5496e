// SPDX-License-Identifier: BSD-3-Clause
#include "certificate.h"
#include "two_bodies.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <variant>

using namespace brink;
using support::Random;

namespace {

Box random_box(Random& random)
{
    const double x = random.chance(0.1) ? 0 : random.between(0.01, 1), y = random.between(0.01, 1);
    const double z = random.log_between(1e-3, 4);
    return {Vec3(x, y, z)};
}

/// At rest, glued to either body, or anything.
V3 any_spin(Random& random, const TwoBodies<Core>& s)
{
    const V3 any = load(random.in_cube(4));
    const int choice = random.index(4);
    return choice == 0 ? V3{} : choice == 1 ? s.a.turn.rate : choice == 2 ? s.b.turn.rate : any;
}

/// A segment, cylinder, cone, ellipsoid or, half of the time, a box: some of them flat or long.
Shape random_shape(Random& random, int kind)
{
    const double radius = random.log_between(0.01, 1), half_length = random.log_between(0.01, 2);
    const Box box = random_box(random);
    switch (kind) {
    case 0:
        return Capsule{Vec3(0, 0, -half_length), Vec3(0.1, 0, half_length), 0};
    case 1:
        return Cylinder{half_length, radius};
    case 2:
        return Cone{half_length, radius};
    case 3:
        return Ellipsoid{box.half_extents};
    default:
        return box;
    }
}

Mover<Core> moving_core(const Shape& shape, const Motion& motion)
{
    if (const auto* s = std::get_if<Capsule>(&shape)) return mover(*s, motion);
    if (const auto* s = std::get_if<Cylinder>(&shape)) return mover(*s, motion);
    if (const auto* s = std::get_if<Cone>(&shape)) return mover(*s, motion);
    if (const auto* s = std::get_if<Ellipsoid>(&shape)) return mover(*s, motion);
    return mover(std::get<Box>(shape), motion);
}

} // namespace

TEST_CASE("safe_step: no gap opens into contact within a certified step, whatever the axis and its spin")
{
    Random random(11);
    int certified = 0, whole = 0;
    for (int i = 0; i < 40'000; ++i) {
        const Shape a = random_shape(random, i % 8), b = random_shape(random, i / 8 % 8);
        const Motion motion_a = random_motion(random, 3), motion_b = random_motion(random, 3);
        const TwoBodies<Core> scene{moving_core(a, motion_a), moving_core(b, motion_b)};
        const double t = random.between(0, 0.9);
        const bool best_axis = random.chance(0.7);
        const V3 any = load(random.unit()), spin = any_spin(random, scene);
        const Moment<Core> s(scene, t);
        const TurningAxis axis{best_axis ? scene.at(t).normal : any, spin};
        const double horizon = 1 - t;
        const Step step = safe_step(s.facing(), axis, horizon);
        if (!(step.gap > 1e-9)) continue;
        CAPTURE(i);
        CHECK(step.length > 0);
        CHECK(step.length <= horizon);
        double least = infinity;
        for (int k = 0; k <= 64; ++k)
            least = std::min(least, scene.at(t + step.length * k / 64).gap);
        CHECK(least > -1e-12);
        ++certified;
        whole += step.length == horizon;
    }
    CHECK(certified > 10'000);
    CHECK(whole > 200);
    CHECK(whole < certified - 4'000);
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
