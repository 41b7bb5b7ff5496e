// SPDX-License-Identifier: BSD-3-Clause
#include "edge_step.h"
#include "support.h"
#include "support/turn_onto.h"
#include "two_bodies.h"

#include <brink/toi.h>
#include <doctest/doctest.h>

using namespace brink;
using support::Random;

TEST_CASE("edge_step: no gap opens into contact while the axis across two edges goes with them")
{
    Random random(181);
    int certified = 0, longer = 0, rounded = 0, round = 0;
    for (int i = 0; i < 40'000; ++i) {
        const bool still = random.chance(0.5), grown = random.chance(0.3);
        Motion motion_a = random_motion(random, 2), motion_b = random_motion(random, 2);
        if (still) motion_b.rotation = Vec3(0, 0, 0);
        const Shape a = random_shape(random, i % 8), b = random_shape(random, i / 8 % 8);
        const TwoBodies<Core> scene{moving_core(a, motion_a), moving_core(b, motion_b)};
        const double t = random.between(0, 0.9);
        const Separation now = scene.at(t);
        const Moment<Core> s(scene, t);
        Facing<Core> f = s.facing();
        const double margin = grown && now.gap > 0 ? random.between(0.5, 1) * now.gap : 0;
        f.margin = margin;
        const Step step = edge_step(f, now.normal, 1 - t);
        if (!(step.gap > 1e-9)) continue;
        CAPTURE(i);
        CHECK(step.length > 0);
        CHECK(step.length <= 1 - t);
        CHECK(least_gap(scene, t, step.length) > margin - 1e-12);
        ++certified;
        rounded += margin > 0;
        round += !is_polytope(scene.a.part) && !is_polytope(scene.b.part);
        longer += step.length > 1.01 * safe_step(f, {now.normal, {}}, 1 - t).length;
    }
    CHECK(certified > 8'000);
    CHECK(rounded > 2'000);
    CHECK(longer > 300);
    CHECK(round > 1'000);
}

namespace {

/// How long a step is proven for a bar that swings on its edge at the origin, a hair above what lies below.
double swinging_above(const auto& below, const Motion& at, double hair)
{
    constexpr double half = 0.70710678118654757; // of a diagonal of 2
    Motion swing;
    swing.start.orientation = support::turn_onto(Vec3(0, -1, -1), Vec3(0, 0, -1));
    swing.pivot = Vec3(0, -half, -half);
    swing.start.position = Vec3(0, 0, 1 + hair);
    swing.rotation = Vec3(0, 0.3, 0.7); // its ends go up and down, and it turns across what is below
    const Box bar{Vec3(3, half, half)};
    const TwoBodies<Core> scene{mover(bar, swing), mover(below, at)};
    const Separation now = scene.at(0);
    REQUIRE(now.gap == doctest::Approx(hair).epsilon(1e-3));
    const Step step = edge_step(Moment<Core>(scene, 0).facing(), now.normal, 1);
    CHECK(least_gap(scene, 0, step.length) > 0);
    return step.length;
}

/// A shape with its point below (x, 0, z) of its own axes straight at the origin.
Motion below(double x, double z)
{
    Motion m;
    m.start.orientation = support::turn_onto(Vec3(x, 0, z), Vec3(0, 0, 1));
    m.start.position = m.start.orientation * Vec3(-x, 0, -z);
    return m;
}

} // namespace

TEST_CASE("edge_step: a bar that swings on its edge a hair above what is round")
{
    Motion needle;
    needle.start.orientation = support::turn_onto(Vec3(1, 0, 0), Vec3(1, 1, 0));
    needle.start.position = Vec3(0, 0, -1e-6);
    CHECK(swinging_above(Cylinder{0.5, 0.5}, below(0.5, 0.5), 1e-8) > 0.1); // a rim
    CHECK(swinging_above(Cone{0.5, 0.5}, below(0.5, -0.5), 1e-8) > 0.1);
    CHECK(swinging_above(Cylinder{0, 0.5}, below(0.5, 0), 1e-8) > 0.1);             // a disc
    CHECK(swinging_above(Ellipsoid{Vec3(0.5, 0.5, 0)}, below(0.5, 0), 1e-8) > 0.1); // the same
    CHECK(swinging_above(Ellipsoid{Vec3(2, 1e-6, 1e-6)}, needle, 1e-8) > 0.1);      // nearly a line
}

TEST_CASE("edge_step: a bar that swings on its edge, a hair above another bar across")
{
    // Both edges are up to 1e-8 apart for a quarter of a turn about the first; the axis turns all the way.
    Motion swing;
    swing.start.position = Vec3(0, 0, 1 + 1e-8);
    swing.start.orientation = support::turn_onto(Vec3(0, -1, -1), Vec3(0, 0, -1));
    swing.pivot = Vec3(0, -0.70710678118654757, -0.70710678118654757);
    swing.rotation = Vec3(0, 0, 1);
    const Box bar{Vec3(3, 0.70710678118654757, 0.70710678118654757)};
    Motion still;
    still.start.orientation = Quat(Eigen::AngleAxisd(2.0, Vec3(0, 0, 1))) * swing.start.orientation;
    still.start.position = Vec3(0, 0, -1);
    swing.start.position = -(swing.start.orientation * swing.pivot) + Vec3(0, 0, 1e-8);
    const TwoBodies<Core> scene{mover(bar, swing), mover(bar, still)};
    const Separation now = scene.at(0);
    REQUIRE(now.gap == doctest::Approx(1e-8).epsilon(1e-3));
    const Step step = edge_step(Moment<Core>(scene, 0).facing(), now.normal, 1);
    CHECK(step.length > 0.1);
    CHECK(time_of_impact(bar, swing, bar, still).status == Status::separated);
}

TEST_CASE("edge_step: bars that swing on the place where their edges cross, which alone bends nothing")
{
    constexpr double half = 0.70710678118654757; // of a diagonal of 2
    Random random(182);
    int certified = 0, partly = 0;
    for (int i = 0; i < 4'000; ++i) {
        const double hair = random.log_between(1e-8, 1e-4), across = random.between(0.5, 2.6);
        Motion above, below;
        above.start.orientation = support::turn_onto(Vec3(0, -1, -1), Vec3(0, 0, -1));
        above.start.position = Vec3(0, 0, 1 + hair);
        above.pivot = Vec3(0, -half, -half);
        above.rotation = random.in_cube(3);
        below.start.orientation = Quat(Eigen::AngleAxisd(across, Vec3(0, 0, 1))) * above.start.orientation;
        below.start.position = Vec3(0, 0, -1);
        below.pivot = Vec3(0, half, half);
        if (random.chance(0.7)) below.rotation = random.in_cube(3);
        const double length = random.between(0.2, 3);
        const TwoBodies<Core> scene{mover(Box{Vec3(length, half, half)}, above),
                                    mover(Box{Vec3(length, half, half)}, below)};
        const Step step = edge_step(Moment<Core>(scene, 0).facing(), {0, 0, -1}, 1);
        if (!(step.gap > 0)) continue;
        CAPTURE(i);
        CHECK(least_gap(scene, 0, step.length) > -1e-12);
        ++certified;
        partly += step.length < 1;
    }
    CHECK(certified > 3'000);
    CHECK(partly > 2'000);
}

TEST_CASE("edge_step: what is round swings on the place where it crosses an edge")
{
    constexpr double half = 0.70710678118654757;
    Random random(183);
    int certified = 0, partly = 0;
    for (int i = 0; i < 12'000; ++i) {
        const double length = random.log_between(0.1, 2), radius = random.log_between(0.1, 2);
        const Shape shapes[] = {Cylinder{length, radius}, Cone{length, radius}, Cylinder{length, radius},
                                Ellipsoid{Vec3(radius, length, 0)}};
        const double place[] = {length, -length, 0, 0}; // rim, rim, side, rim
        const double hair = random.log_between(1e-8, 1e-4), z = place[i % 4];
        const Vec3 lowest(radius, 0, z);
        Motion above, below;
        above.start.orientation = support::turn_onto(lowest, Vec3(0, 0, -1));
        above.start.position = Vec3(0, 0, hair) - above.start.orientation * lowest;
        above.pivot = lowest;
        above.rotation = random.in_cube(3);
        below.start.orientation = Quat(Eigen::AngleAxisd(random.between(0, 3), Vec3(0, 0, 1))) *
                                  support::turn_onto(Vec3(0, 1, 1), Vec3(0, 0, 1));
        below.start.position = Vec3(0, 0, -1);
        below.pivot = Vec3(0, half, half);
        if (random.chance(0.5)) below.rotation = random.in_cube(3);
        const TwoBodies<Core> scene{moving_core(shapes[i % 4], above),
                                    mover(Box{Vec3(random.between(0.2, 3), half, half)}, below)};
        const Step step = edge_step(Moment<Core>(scene, 0).facing(), {0, 0, -1}, 1);
        if (!(step.gap > 0)) continue;
        CAPTURE(i);
        CHECK(least_gap(scene, 0, step.length) > -1e-12);
        ++certified;
        partly += step.length > 0 && step.length < 1;
    }
    CHECK(certified > 9'000);
    CHECK(partly > 5'000);
}

TEST_CASE("edge_step: nothing of a point, which has no line")
{
    const TwoBodies<Core> scene{mover(Sphere{1}, Motion{}),
                                mover(Box{Vec3(1, 1, 1)}, Motion{Pose{Vec3(9, 0, 0)}})};
    CHECK(edge_step(Moment<Core>(scene, 0).facing(), {1, 0, 0}, 1).length == 0);
}
