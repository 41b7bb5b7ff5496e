// SPDX-License-Identifier: BSD-3-Clause
#include "certificate.h"
#include "support.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace brink;
using support::Random;

namespace {

Box random_box(Random& random)
{
    const double x = random.chance(0.1) ? 0 : random.between(0.01, 1), y = random.between(0.01, 1);
    const double z = random.log_between(1e-3, 4);
    return {Vec3(x, y, z)};
}

Motion random_motion(Random& random, double reach)
{
    Motion m;
    m.start.position = random.in_cube(reach);
    m.start.orientation = random.rotation();
    m.translation = random.in_cube(2);
    const double turns = random.log_between(1e-3, 8);
    const Vec3 axis = random.unit();
    m.rotation = Vec3(turns * axis.x(), turns * axis.y(), turns * axis.z());
    if (random.chance(0.5)) m.pivot = random.in_cube(1);
    return m;
}

/// The separation along `axis` at time t, and everything a certificate asks for.
struct Scene {
    Mover<Core> a, b;

    V3 offset(double t) const
    {
        return (b.position - a.position) + (b.arm - a.arm) + t * (b.translation - a.translation);
    }
    Separation at(double t) const
    {
        return separation(a.turned_to(t), placed(b.turned_to(t), {}, offset(t)));
    }
};

double along(const Core& a, const Core& b, V3 offset, V3 axis)
{
    double most_a = -infinity, least_b = infinity;
    for (int k = 0; k < a.count; ++k)
        most_a = std::max(most_a, dot(axis, corner(a, k)));
    for (int k = 0; k < b.count; ++k)
        least_b = std::min(least_b, dot(axis, corner(b, k) + offset));
    return least_b - most_a;
}

struct Sample {
    Core a, b;
    Facing facing;
};

Sample sample(const Scene& s, double t, V3 axis)
{
    Sample at{s.a.turned_to(t), s.b.turned_to(t), {}};
    const V3 offset = s.offset(t);
    at.facing = {{nullptr, 0, s.a.reach, s.a.turn.rate}, {nullptr, 0, s.b.reach, s.b.turn.rate}, axis, offset,
                 s.b.translation - s.a.translation,      along(at.a, at.b, offset, axis)};
    return at;
}

} // namespace

TEST_CASE("safe_step: no gap opens into contact within a certified step, whatever the axis")
{
    Random random(11);
    int certified = 0, whole = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Box a = random_box(random), b = random_box(random);
        const Motion motion_a = random_motion(random, 3), motion_b = random_motion(random, 3);
        const Scene scene{mover(a, motion_a), mover(b, motion_b)};
        const double t = random.between(0, 0.9);
        const bool best_axis = random.chance(0.7);
        const V3 any = load(random.unit());
        Sample s = sample(scene, t, best_axis ? scene.at(t).normal : any);
        s.facing.a.core = &s.a;
        s.facing.b.core = &s.b;
        if (!(s.facing.gap > 1e-9)) continue;
        const double horizon = 1 - t, step = safe_step(s.facing, horizon);
        CAPTURE(i);
        CHECK(step > 0);
        CHECK(step <= horizon);
        double least = infinity;
        for (int k = 0; k <= 64; ++k)
            least = std::min(least, scene.at(t + step * k / 64).gap);
        CHECK(least > -1e-12);
        ++certified;
        whole += step == horizon;
    }
    CHECK(certified > 5'000);
    CHECK(whole > 200);
    CHECK(whole < certified - 2'000);
}

TEST_CASE("rising_step: the gap stays at or above where it was")
{
    Random random(12);
    int rising = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Box a = random_box(random), b = random_box(random);
        const Motion motion_a = random_motion(random, 1.5), motion_b = random_motion(random, 1.5);
        const Scene scene{mover(a, motion_a), mover(b, motion_b)};
        const double t = random.between(0, 0.9);
        Sample s = sample(scene, t, scene.at(t).normal);
        s.facing.a.core = &s.a;
        s.facing.b.core = &s.b;
        const double step = rising_step(s.facing, 1 - t);
        if (step == 0) continue;
        CAPTURE(i);
        double least = infinity;
        for (int k = 0; k <= 64; ++k)
            least = std::min(least, scene.at(t + step * k / 64).gap);
        CHECK(least > s.facing.gap - 1e-12);
        ++rising;
    }
    CHECK(rising > 3'000);
    CHECK(rising < 17'000);
}
