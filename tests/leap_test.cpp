// SPDX-License-Identifier: BSD-3-Clause
#include "leap.h"
#include "two_bodies.h"

#include <algorithm>
#include <doctest/doctest.h>

using namespace brink;
using support::Random;

namespace {

struct Tally {
    int leaps = 0, whole = 0, back = 0;
};

/// A leap from the start must prove what it says: apart from where it begins to where it lands, and there
/// within the tolerance of contact.
void check_leap(const Core& a, const Core& b, const Motion& motion_a, const Motion& motion_b, Tally& tally)
{
    const TwoBodies<Core> bodies{mover(a, motion_a), mover(b, motion_b)};
    const Options options;
    Course<Core> course(bodies.a, bodies.b, options);
    if (course.window.empty || bodies.at(course.window.begin).gap < 0.01) return;
    course.go(course.window.begin);
    const double start = course.now();
    Watch watch(bodies.a.part, bodies.b.part, course.radii + course.tolerance);
    Sight seen = watch.look(course.facing());
    if (!watch.far_sighted()) seen = watch.look(course.facing());
    Leap found;
    const bool leaps = leap(course, watch, seen, found);
    if (!leaps) {
        CHECK(course.now() == start);
        ++tally.back;
        return;
    }
    ++tally.leaps;
    if (found.from <= start) ++tally.whole;
    CHECK(course.now() == (found.from > start ? start : found.at));
    CHECK(found.from < found.at);
    CHECK(found.at < course.window.end);
    const double landed = bodies.at(found.at).gap;
    CHECK(landed <= course.tolerance + course.rounding);
    CHECK(landed >= -course.rounding);
    const double from = std::max(found.from, start);
    for (int k = 0; k < 64; ++k)
        CHECK(bodies.at(from + (found.at - from) * k / 64).gap >= -course.rounding);
}

Core random_core(Random& random, int kind)
{
    const Vec3 half = random.in_cube(1).cwiseAbs();
    if (kind == 0) return core(Sphere{random.between(0.1, 1)});
    if (kind == 1) return core(Capsule{random.in_cube(1), random.in_cube(1), random.between(0.1, 0.5)});
    if (kind == 2) return core(Box{half});
    return core(Triangle{random.in_cube(1), random.in_cube(1), random.in_cube(1)});
}

} // namespace

TEST_CASE("leap: the way is apart, its end within the tolerance of contact")
{
    Random random(161);
    for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) {
            Tally tally;
            for (int i = 0; i < 2'000; ++i) {
                CAPTURE(a);
                CAPTURE(b);
                CAPTURE(i);
                const Core of_a = random_core(random, a), of_b = random_core(random, b);
                Motion motion_a = random_motion(random, 3), motion_b = random_motion(random, 3);
                motion_b.translation = motion_a.start.position - motion_b.start.position + random.in_cube(1);
                check_leap(of_a, of_b, motion_a, motion_b, tally);
            }
            CHECK(tally.leaps > 40);
            CHECK(tally.whole > 30);
            CHECK(tally.back > 50);
        }
}

TEST_CASE("leap: no more looks than the budget has left")
{
    Options options;
    options.max_iterations = 1;
    Motion motion_b;
    motion_b.start.position = Vec3(3, 0, 0);
    motion_b.translation = Vec3(-4, 0, 0);
    motion_b.rotation = Vec3(0, 0, 1);
    const Mover<Core> a = mover(core(Sphere{1}), Motion{}), b = mover(core(Box{{0.5, 0.5, 0.5}}), motion_b);
    Course<Core> course(a, b, options);
    course.go(course.window.begin);
    Watch watch(a.part, b.part, course.radii + course.tolerance);
    course.iterations = 1;
    Leap found;
    CHECK(!leap(course, watch, watch.look(course.facing()), found));
    CHECK(course.iterations == 1);
}
