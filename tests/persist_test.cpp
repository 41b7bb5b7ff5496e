// SPDX-License-Identifier: BSD-3-Clause
#include "falling.h"
#include "persist.h"
#include "two_bodies.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace brink;
using support::Random;

namespace {

struct Tally {
    int lasting = 0, to_the_end = 0;
};

template <class Part>
void check_lasting(const TwoBodies<Part>& scene, double t, double reach, double gap, Tally& tally)
{
    const Moment<Part> moment(scene, t);
    const double step = contact_step(moment.facing(), separation(moment.a, moment.b), reach, 1 - t);
    if (!(step > 0)) return;
    double most = -infinity;
    for (int k = 0; k <= 64; ++k)
        most = std::max(most, scene.at(t + step * k / 64).gap);
    CHECK(most <= gap + 1e-12);
    ++tally.lasting;
    tally.to_the_end += step == 1 - t;
}

} // namespace

TEST_CASE("last_kept: what bisection finds, less next to nothing")
{
    Random random(56);
    int spent = 0;
    for (int i = 0; i < 10'000; ++i) {
        Trend lines[4];
        for (Trend& line : lines) {
            line.now = random.log_between(1e-9, 1);
            line.rate = (random.chance(0.5) ? -1 : 1) * random.log_between(1e-3, 100);
        }
        const int count = 1 + i % 4;
        const double curvature = random.chance(0.3) ? 0 : random.log_between(1e-3, 1e5);
        int calls = 0;
        const auto concave = [&](double h) {
            ++calls;
            double least = infinity;
            for (int k = 0; k < count; ++k)
                least = std::min(least, lines[k].now + h * lines[k].rate);
            return least;
        };
        const double kept = last_kept(concave, curvature, 1);
        spent += calls;
        double good = 0, bad = 1;
        while (bad - good > 1e-15) {
            const double h = 0.5 * (good + bad);
            (concave(h) >= 0.5 * curvature * h * h ? good : bad) = h;
        }
        CAPTURE(i);
        CHECK(kept >= (1 - 1e-5) * good);
        CHECK(kept <= bad * (1 + 1e-6));
    }
    CHECK(spent < 100'000);
    CHECK(last_kept([](double h) { return 1 - h; }, 0, 0.5) == 0.5);
    CHECK(last_kept([](double h) { return h - 0.5; }, 0, 1) == 0);
}

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
        const TwoBodies<Core> scene{moving, other};
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
        const TwoBodies<Core> scene{mover(a, motion_a), mover(b, motion_b)};
        if (scene.at(t).gap < gap) check_lasting(scene, t, 2 * radius + gap, gap, tally);
    }
    CHECK(tally.lasting > 2'000);
}

TEST_CASE("contact_step: cores that overlap, until the last of it")
{
    // To first order contact could end in the time that the fastest points take for the depth.
    Random random(54);
    Tally tally;
    int shallow = 0, beyond_first_order = 0;
    for (int i = 0; i < 20'000; ++i) {
        const TwoBodies<Core> scene = random_bodies(random, i, 0.6);
        const double t = random.between(0, 0.9);
        CAPTURE(i);
        const Moment<Core> moment(scene, t);
        const double radii = moment.a.radius + moment.b.radius;
        const Separation now = separation(moment.a, moment.b);
        if (!(now.gap + radii < 0)) continue;
        check_lasting(scene, t, radii, 0, tally);
        const Facing<Core> f = moment.facing();
        const double step = contact_step(f, now, radii, 1 - t);
        const double fastest = norm(f.velocity) + f.a.angle * f.a.reach + f.b.angle * f.b.reach;
        const double depth = -(now.gap + radii);
        if (depth > 0.02 || radii > 0) continue;
        ++shallow;
        beyond_first_order += step * fastest > 2 * depth;
    }
    CHECK(tally.lasting > 3'200);
    CHECK(shallow > 150);
    CHECK(beyond_first_order > 0.6 * shallow);
}

TEST_CASE("contact_step: an edge, a side or a rim that slides out is followed to the end in few steps")
{
    // A point that goes with its body is left behind: the way out would shrink by a tenth or so each time.
    Random random(55);
    int ended = 0, most = 0;
    for (int i = 0; i < 1'500; ++i) {
        const Triangle triangle{random.unit(), random.unit(), random.unit()};
        const double x = random.between(0.1, 1), y = random.between(0.1, 1);
        const Box box{Vec3(x, y, 0.3)};
        const Shape solids[] = {box, Cylinder{x, y}, Cone{x, y}, Cylinder{0, y}};
        const Motion motion_a = random_motion(random, 0.6), motion_b = random_motion(random, 0.6);
        CAPTURE(i);
        const Mover<Core> edges = i % 4 == 3 ? mover(box, motion_a) : mover(triangle, motion_a);
        const TwoBodies<Core> scene{edges, moving_core(solids[i % 4], motion_b)};
        int shallow = 0;
        double t = random.between(0, 0.5);
        for (int k = 0; k < 200 && t < 1; ++k) {
            const Moment<Core> moment(scene, t);
            const Separation now = separation(moment.a, moment.b);
            if (!(now.gap < -1e-9)) break;
            const Facing<Core> f = moment.facing();
            const double fastest = norm(f.velocity) + f.a.angle * f.a.reach + f.b.angle * f.b.reach;
            t += std::max(contact_step(f, now, 0, 1 - t), -now.gap / fastest);
            shallow += now.gap > -1e-3;
        }
        ended += shallow > 0;
        most = std::max(most, shallow);
    }
    CHECK(ended > 100);
    CHECK(most < 20);
}

TEST_CASE("overlap_step: cores stay as deep in each other as is to be kept")
{
    Random random(57);
    int proven = 0, far = 0;
    for (int i = 0; i < 20'000; ++i) {
        const TwoBodies<Core> scene = random_bodies(random, i, 0.6);
        const double t = random.between(0, 0.9), part = random.between(0, 1), rate = random.between(0, 3);
        const Moment<Core> moment(scene, t);
        const Separation now = separation(moment.a, moment.b);
        if (!(now.gap < 0)) continue;
        CAPTURE(i);
        const Kept kept{part * -now.gap, rate};
        const double step = overlap_step(moment.facing(), now, kept, 1 - t);
        if (!(step > 0)) continue;
        double least = infinity;
        for (int k = 0; k <= 64; ++k) {
            const double h = step * k / 64;
            least = std::min(least, -scene.at(t + h).gap - std::max(0.0, kept.depth - kept.rate * h));
        }
        CHECK(least >= -1e-12);
        ++proven;
        far += step * rate > kept.depth;
    }
    CHECK(proven > 1'000);
    CHECK(far > 100);
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
        const TwoBodies<Border> scene{mover(box, motion_a), border};
        if (scene.at(t).gap < 0) check_lasting(scene, t, 0, 0, tally);
    }
    CHECK(tally.lasting > 2'000);
    CHECK(tally.to_the_end < tally.lasting - 200);
}
