// SPDX-License-Identifier: BSD-3-Clause
#include "persist.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace brink;
using support::Random;

namespace {

Motion random_motion(Random& random, double reach)
{
    Motion m;
    m.start.position = random.in_cube(reach);
    m.start.orientation = random.rotation();
    m.translation = random.in_cube(2);
    const double angle = random.log_between(1e-3, 8);
    const Vec3 axis = random.unit();
    m.rotation = angle * axis;
    if (random.chance(0.5)) m.pivot = random.in_cube(1);
    return m;
}

template <class Part> struct Scene {
    Mover<Core> a;
    Mover<Part> b;

    V3 offset(double t) const
    {
        return (b.position - a.position) + (b.arm - a.arm) + t * (b.translation - a.translation);
    }
    Separation at(double t) const
    {
        return separation(a.turned_to(t), placed(b.turned_to(t), {}, offset(t)));
    }
    double contact_lasts(double t, double reach) const
    {
        const Core part_a = a.turned_to(t);
        const Part part_b = placed(b.turned_to(t), {}, offset(t));
        const Facing<Part> f{{part_a, {}, a.reach, a.turn.rate, a.turn.angle},
                             {part_b, offset(t), b.reach, b.turn.rate, b.turn.angle},
                             b.translation - a.translation,
                             0};
        return contact_step(f, separation(part_a, part_b), reach, 1 - t);
    }
};

struct Tally {
    int lasting = 0, to_the_end = 0;
};

template <class Part>
void check_lasting(const Scene<Part>& scene, double t, double reach, double gap, Tally& tally)
{
    const double step = scene.contact_lasts(t, reach);
    if (!(step > 0)) return;
    double most = -infinity;
    for (int k = 0; k <= 64; ++k)
        most = std::max(most, scene.at(t + step * k / 64).gap);
    CHECK(most <= gap + 1e-12);
    ++tally.lasting;
    tally.to_the_end += step == 1 - t;
}

} // namespace

TEST_CASE("contact_step: solid cores stay in contact, whatever they do")
{
    Random random(51);
    Tally tally;
    for (int i = 0; i < 8'000; ++i) {
        const double x = random.between(0.1, 1), y = random.between(0.1, 1), z = random.between(0.1, 1);
        const Box box{Vec3(x, y, z)};
        const Cylinder cylinder{x, y};
        const Cone cone{y, z};
        const Ellipsoid ellipsoid{Vec3(z, x, y)};
        const Motion motion_a = random_motion(random, 0.6), motion_b = random_motion(random, 0.6);
        const double t = random.between(0, 0.9);
        CAPTURE(i);
        const Mover<Core> moving = mover(box, motion_a);
        const int kind = i % 3;
        const Mover<Core> other = kind == 0   ? mover(cylinder, motion_b)
                                  : kind == 1 ? mover(cone, motion_b)
                                              : mover(ellipsoid, motion_b);
        const Scene<Core> scene{moving, other};
        if (scene.at(t).gap < 0) check_lasting(scene, t, 0, 0, tally);
    }
    CHECK(tally.lasting > 1'200);
    CHECK(tally.to_the_end < tally.lasting - 200);
}

TEST_CASE("contact_step: radii and a target gap count")
{
    Random random(52);
    Tally tally;
    for (int i = 0; i < 8'000; ++i) {
        const double radius = random.between(0.1, 0.5), gap = random.between(0, 0.5);
        const Vec3 end = random.in_cube(1), other_end = random.in_cube(1);
        const Capsule a{-end, end, radius}, b{-other_end, other_end, radius};
        const Motion motion_a = random_motion(random, 0.6), motion_b = random_motion(random, 0.6);
        const double t = random.between(0, 0.9);
        CAPTURE(i);
        const Scene<Core> scene{mover(a, motion_a), mover(b, motion_b)};
        if (scene.at(t).gap < gap) check_lasting(scene, t, 2 * radius + gap, gap, tally);
    }
    CHECK(tally.lasting > 2'000);
}

TEST_CASE("contact_step: planes and half-spaces")
{
    Random random(53);
    Tally tally;
    for (int i = 0; i < 8'000; ++i) {
        const double x = random.between(0.1, 1), y = random.between(0.1, 1), z = random.between(0.1, 1);
        const Box box{Vec3(x, y, z)};
        const Vec3 normal = random.unit();
        const Motion motion_a = random_motion(random, 0.6), motion_b = random_motion(random, 0.6);
        const double t = random.between(0, 0.9);
        CAPTURE(i);
        const Mover<Border> border =
            i % 2 == 0 ? mover(Plane{normal, 0}, motion_b) : mover(HalfSpace{normal, 0}, motion_b);
        const Scene<Border> scene{mover(box, motion_a), border};
        if (scene.at(t).gap < 0) check_lasting(scene, t, 0, 0, tally);
    }
    CHECK(tally.lasting > 2'000);
    CHECK(tally.to_the_end < tally.lasting - 200);
}
