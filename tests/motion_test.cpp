// SPDX-License-Identifier: BSD-3-Clause
#include "support/moving.h"
#include "support/random.h"

#include <brink/motion.h>

#include <doctest/doctest.h>

#include <cmath>

using namespace brink;
using support::Random;

namespace {

constexpr double pi = 3.141592653589793;

Vec3 world(const Pose& pose, const Vec3& local) { return pose.isometry() * local; }

Motion random_motion(Random& random, double angle)
{
    Motion m;
    m.start.position = random.in_cube(5);
    m.start.orientation = random.rotation();
    m.translation = random.in_cube(5);
    const Vec3 axis = random.unit();
    const double turn = random.between(0, angle);
    m.rotation = turn * axis;
    if (random.chance(0.7)) m.pivot = random.in_cube(2);
    return m;
}

} // namespace

TEST_CASE("Motion::at: the pivot moves in a straight line and everything else turns about it")
{
    Motion m{
        .start = {Vec3(1, 0, 0), Quat(1, 0, 0, 0)}, .translation = Vec3(0, 0, 4), .rotation = Vec3(0, 0, pi)};
    m.pivot = Vec3(2, 0, 0);
    const Pose half = m.at(0.5); // a quarter turn about the point (3, 0, .)
    CHECK((world(half, Vec3(2, 0, 0)) - Vec3(3, 0, 2)).norm() < 1e-15);
    CHECK((world(half, Vec3(3, 0, 0)) - Vec3(3, 1, 2)).norm() < 1e-15);
    CHECK(m.at(0).position == Vec3(1, 0, 0));
}

TEST_CASE("Motion::still does not move")
{
    const Pose pose{Vec3(1, 2, 3), Quat(0.5, 0.5, 0.5, 0.5)};
    CHECK(Motion::still(pose).at(1).position == pose.position);
    CHECK(Motion::still(pose).at(1).orientation.coeffs() == pose.orientation.coeffs());
}

TEST_CASE("Motion::between ends where it was told to, by the shorter turn")
{
    Random random(21);
    for (int i = 0; i < 10'000; ++i) {
        const Vec3 from_at = random.in_cube(5), to_at = random.in_cube(5), pivot = random.in_cube(1);
        const Quat from_turn = random.rotation(), to_turn = random.rotation();
        const Pose from{from_at, from_turn}, to{to_at, random.chance(0.1) ? from_turn : to_turn};
        const Motion m = Motion::between(from, to, pivot);
        const Pose end = m.at(1);
        CAPTURE(i);
        CHECK((end.position - to.position).norm() < 1e-14 * 10);
        CHECK(std::fabs(end.orientation.dot(to.orientation)) == doctest::Approx(1).epsilon(1e-14));
        CHECK(m.rotation.norm() <= pi + 1e-14);
        CHECK((world(m.at(0.5), pivot) - 0.5 * (world(from, pivot) + world(to, pivot))).norm() < 1e-13);
    }
}

TEST_CASE("swept_bounds: holds every point at every time, and a translation's are tight")
{
    Random random(22);
    const Box box{Vec3(0.5, 1, 0.1)};
    for (int i = 0; i < 3'000; ++i) {
        const Motion m = random_motion(random, random.chance(0.5) ? 1 : 20);
        const double t_max = random.between(0, 1);
        const Aabb swept = swept_bounds(box, m, t_max);
        CAPTURE(i);
        for (int k = 0; k <= 32; ++k) {
            const Aabb now = bounds(box, m.at(t_max * k / 32));
            // Two roundings of the same corner: allow for those of Motion::at.
            CHECK((now.min.array() >= swept.min.array() - 1e-13).all());
            CHECK((now.max.array() <= swept.max.array() + 1e-13).all());
        }
    }
    const Aabb tight = swept_bounds(Sphere{1}, support::moving(Vec3(0, 0, 0), Vec3(4, 0, -2)), 0.5);
    CHECK((tight.min - Vec3(-1, -1, -2)).norm() < 1e-12);
    CHECK((tight.max - Vec3(3, 1, 1)).norm() < 1e-12);
}

TEST_CASE("swept_bounds: a full turn stays within reach of the pivot; bad input is everywhere")
{
    const Capsule rod{Vec3(0, 0, 0), Vec3(2, 0, 0), 0.5};
    const Motion spin{.rotation = Vec3(0, 0, 2 * pi)};
    const Aabb swept = swept_bounds(rod, spin);
    CHECK(swept.max.y() == doctest::Approx(2.5));
    CHECK(swept.min.x() == doctest::Approx(-2.5));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(swept_bounds(rod, support::resting(Vec3(nan, 0, 0))).min.y() == -infinity);
    CHECK(swept_bounds(Sphere{-1}, {}).max.x() == infinity);
    CHECK(swept_bounds(Sphere{1}, {}, 1.5).max.x() == infinity);
    CHECK(swept_bounds(HalfSpace{}, spin).max.z() == infinity);
}
