// SPDX-License-Identifier: BSD-3-Clause
#include "spindle.h"

#include "two_bodies.h"

#include <doctest/doctest.h>

using namespace brink;
using support::Random;

namespace {

/// Turns often, if at all, and goes hardly anywhere.
Motion whirling(Random& random)
{
    Motion m = random_motion(random, 0.4);
    const double slow = random.log_between(1e-3, 1), fast = random.chance(0.7) ? 60 : 1;
    m.translation = Vec3(slow * m.translation.x(), slow * m.translation.y(), slow * m.translation.z());
    m.rotation = Vec3(fast * m.rotation.x(), fast * m.rotation.y(), fast * m.rotation.z());
    if (random.chance(0.1)) m.rotation = Vec3(0, 0, 0);
    return m;
}

struct Tally {
    int proven = 0, in_turns = 0; // by more than a turn of the faster body
};

template <class Part> void check_lasting(const TwoBodies<Part>& bodies, double t, double reach, Tally& tally)
{
    const Moment<Part> moment(bodies, t);
    const Facing<Part> f = moment.facing();
    const double step = spindle_step(f, reach, 1 - t);
    CHECK(step <= 1 - t);
    if (!(step > 0)) return;
    double most = -infinity;
    for (int k = 0; k <= 256; ++k)
        most = std::max(most, bodies.at(t + step * k / 256).gap);
    CHECK(most <= reach - moment.a.radius + 1e-12);
    ++tally.proven;
    tally.in_turns += step * std::max(f.a.angle, f.b.angle) > 7;
}

} // namespace

TEST_CASE("spindle_step: bodies stay in contact over many turns")
{
    Random random(171);
    Tally tally;
    for (int i = 0; i < 3'000; ++i) {
        const Shape a = random_shape(random, i % 8), b = random_shape(random, i / 8 % 8);
        const Motion motion_a = whirling(random), motion_b = whirling(random);
        const TwoBodies<Core> bodies{moving_core(a, motion_a), moving_core(b, motion_b)};
        CAPTURE(i);
        check_lasting(bodies, random.between(0, 0.9), random.chance(0.5) ? 0 : 0.3, tally);
    }
    CHECK(tally.proven > 500);
    CHECK(tally.in_turns > 120);
}

TEST_CASE("spindle_step: hulls, triangles and balls off their pivots")
{
    Random random(172);
    Tally tally;
    for (int i = 0; i < 1'500; ++i) {
        std::vector<Vec3> points;
        for (int k = 0; k < 12; ++k)
            points.push_back(random.in_cube(0.6));
        const Hull hull = Hull::from_points(points);
        const double radius = random.between(0.1, 0.8);
        const Motion motion_a = whirling(random), motion_b = whirling(random);
        const double t = random.between(0, 0.9);
        CAPTURE(i);
        if (i % 3 == 0)
            check_lasting(TwoBodies<Core>{mover(Sphere{radius}, motion_a), mover(hull, motion_b)}, t, radius,
                          tally);
        else if (i % 3 == 1)
            check_lasting(TwoBodies<Core>{mover(Triangle{points[0], points[1], points[2]}, motion_a),
                                          mover(Box{Vec3(radius, radius, 0.5)}, motion_b)},
                          t, 0, tally);
        else
            check_lasting(
                TwoBodies<Border>{mover(hull, motion_a), mover(HalfSpace{random.unit(), 0.3}, motion_b)}, t,
                0, tally);
    }
    CHECK(tally.proven > 280);
    CHECK(tally.in_turns > 60);
}

TEST_CASE("spindle_step: planes and half-spaces that turn too")
{
    Random random(173);
    Tally tally;
    for (int i = 0; i < 3'000; ++i) {
        const Shape a = random_shape(random, i % 8);
        const Vec3 normal = random.unit();
        const Motion motion_a = whirling(random), motion_b = whirling(random);
        const double offset = random.between(-0.3, 1);
        const Mover<Border> border =
            i % 3 == 0 ? mover(Plane{normal, offset}, motion_b) : mover(HalfSpace{normal, offset}, motion_b);
        CAPTURE(i);
        check_lasting(TwoBodies<Border>{moving_core(a, motion_a), border}, random.between(0, 0.9), 0, tally);
    }
    CHECK(tally.proven > 700);
    CHECK(tally.in_turns > 150);
}

TEST_CASE("spindle_step: until the ball about the axis lets go")
{
    // A rod that spins about its own length; a ball leaves it sideways, from the midst to where it is as far
    // away as both are thick, and half a unit per step takes a whole one for that.
    Motion spinning, leaving;
    spinning.rotation = Vec3(0, 0, 600);
    leaving.translation = Vec3(0.5, 0, 0);
    const TwoBodies<Core> bodies{mover(Sphere{0.2}, leaving), mover(Box{Vec3(0.1, 0.1, 1)}, spinning)};
    const Moment<Core> moment(bodies, 0);
    // The place on the axis is found to a thousandth or so.
    CHECK(spindle_step(moment.facing(), 0.2, 1) == doctest::Approx(0.6).epsilon(1e-4));
    // Its corners go round outside of that ball.
    CHECK(bodies.at(0.601).gap < 0.01);
    // A hull's faces are as good as a box's.
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; ++k)
        corners.emplace_back(k % 2 == 0 ? 0.1 : -0.1, k / 2 % 2 == 0 ? 0.1 : -0.1, k / 4 == 0 ? 1 : -1);
    const Hull rod = Hull::from_points(corners); // which its mover does not keep
    const TwoBodies<Core> hull{mover(Sphere{0.2}, leaving), mover(rod, spinning)};
    CHECK(spindle_step(Moment<Core>(hull, 0).facing(), 0.2, 1) == doctest::Approx(0.6).epsilon(1e-4));

    // A half-space whose normal goes round a cone of 45 degrees, and the tip of that at its pivot: what hangs
    // half a unit below is in it at all times, the tip's own height is let go at once.
    Motion whirl;
    whirl.rotation = Vec3(0, 0, 600);
    const double c = std::sqrt(0.5);
    Motion down, up;
    down.start.position = Vec3(0, 0, -0.5);
    up.start.position = Vec3(0, 0, -0.5);
    up.translation = Vec3(0, 0, 1);
    const auto step = [&](const Motion& motion) {
        const TwoBodies<Border> over{mover(Sphere{0.1}, motion), mover(HalfSpace{Vec3(c, 0, c), 0}, whirl)};
        return spindle_step(Moment<Border>(over, 0).facing(), 0.1, 1);
    };
    CHECK(step(down) == 1);
    // Beside the axis of a plane's turn the plane sweeps up and down over a ball, which lies half a radius
    // low.
    Motion aside;
    aside.start.position = Vec3(0, 0, -0.05 / c);
    aside.translation = Vec3(1, 0, 0);
    const TwoBodies<Border> swept{mover(Sphere{0.1}, aside), mover(Plane{Vec3(c, 0, c), 0}, whirl)};
    CHECK(spindle_step(Moment<Border>(swept, 0).facing(), 0.1, 1) == doctest::Approx(0.05 / c).epsilon(1e-4));
    CHECK(step(up) == doctest::Approx(0.5 + 0.1 / c).epsilon(1e-6));
}
