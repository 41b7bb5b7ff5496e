// SPDX-License-Identifier: BSD-3-Clause
#include "support/random.h"
#include "support/reference.h"

#include <doctest/doctest.h>

using namespace brink;
using namespace brink::support;

namespace {

Pose at(double x, double y, double z) { return {Vec3(x, y, z), Quat(1, 0, 0, 0)}; }

double gap_between(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b)
{
    return static_cast<double>(
        GapOverTime(Query{a, Motion::still(pose_a), b, Motion::still(pose_b), {}}).at(0).gap);
}

Reference ask(const Query& q) { return reference(q, GapOverTime(q)); }

constexpr double rounding = 1e-15; // sizes of about 1; the reference itself is good to 1e-18

} // namespace

TEST_CASE("reference gap: apart")
{
    const Box cube{Vec3(1, 1, 1)};
    const Triangle flat{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    const Capsule upright{Vec3(0, 0, -1), Vec3(0, 0, 1), 0.5};
    CHECK(gap_between(Sphere{1}, at(0, 0, 0), Sphere{0.5}, at(3, 4, 0)) == 3.5);
    CHECK(gap_between(Sphere{1}, at(4, 5, 1), cube, at(0, 0, 0)) == 4); // an edge, 3-4-5
    CHECK(gap_between(Sphere{0}, at(1, 1, 3), flat, at(0, 0, 0)) == 3);
    CHECK(gap_between(Sphere{0}, at(-3, 1, 4), flat, at(0, 0, 0)) == 5);
    CHECK(gap_between(upright, at(0, 0, 0), upright, at(3, 0, 0)) == 2);
    CHECK(gap_between(upright, at(0, 0, 0), upright, at(3, 0, 6)) == 4);
    CHECK(gap_between(cube, at(0, 0, 0), cube, at(3, 0, 0)) == 1);
    CHECK(gap_between(cube, at(0, 0, 0), cube, at(5, 6, 0)) == 5);
    CHECK(gap_between(cube, at(0, 0, 1.5), flat, at(0, 0, 0)) == 0.5);
    CHECK(gap_between(flat, at(0, 0, 0), flat, at(0, 0, 5)) == 5); // FCL says 5.385
    CHECK(gap_between(flat, at(0, 0, 0), flat, at(5, 0, 0)) == 1);
    CHECK(gap_between(cube, at(0, 0, 3), HalfSpace{Vec3(0, 0, 1), 0.5}, at(0, 0, 1)) == 0.5);
    CHECK(gap_between(Sphere{1}, at(0, 0, -3), Plane{Vec3(0, 0, 1), 0}, at(0, 0, 0)) == 2);
}

TEST_CASE("reference gap: edges crossed at a right angle")
{
    // A cube standing on an edge under one lying on an edge: gap = 4 - 2 sqrt(2).
    const double half = std::sqrt(0.5);
    const double eighth = std::sqrt(0.5 * (1 + half));
    const double s = std::sqrt(1 - eighth * eighth);
    const Pose about_x{Vec3(0, 0, 0), Quat(eighth, s, 0, 0)};
    const Pose about_y{Vec3(0, 0, 4), Quat(eighth, 0, s, 0)};
    const Box cube{Vec3(1, 1, 1)};
    CHECK(std::abs(gap_between(cube, about_x, cube, about_y) - (4 - 2 * std::sqrt(2.0))) < rounding);
}

TEST_CASE("reference gap: overlapping")
{
    const Box cube{Vec3(1, 1, 1)};
    const Capsule upright{Vec3(0, 0, -1), Vec3(0, 0, 1), 0.5};
    const Triangle flat{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    CHECK(gap_between(Sphere{1}, at(0, 0, 0), Sphere{1}, at(1, 0, 0)) == -1);
    CHECK(gap_between(Sphere{0.5}, at(0.25, 0, 0), cube, at(0, 0, 0)) == -1.25);
    CHECK(gap_between(cube, at(0, 0, 0), cube, at(1.5, 0.5, 0)) == -0.5);
    CHECK(gap_between(Capsule{Vec3(-3, 0, 0), Vec3(3, 0, 0), 0.25}, at(0, 0.5, 0), cube, at(0, 0, 0)) ==
          -0.75);
    CHECK(gap_between(upright, at(1, 1, 0), flat, at(0, 0, 0)) == -1.5); // out at the bottom or the top
    CHECK(gap_between(cube, at(1, 1, 0.25), flat, at(0, 0, 0)) == -0.75);
    CHECK(gap_between(Sphere{1}, at(0, 0, 0.25), Plane{Vec3(0, 0, 1), 0}, at(0, 0, 0)) == -0.75);
    CHECK(gap_between(Sphere{1}, at(0, 0, -5), HalfSpace{Vec3(0, 0, 1), 0}, at(0, 0, 0)) == -6);
}

TEST_CASE("reference: translation by hand")
{
    const Query head_on{
        Sphere{1}, {at(5, 0, 0), Vec3(-4, 0, 0)}, Sphere{0.5}, {at(0, 0, 0), Vec3(3, 0, 0)}, {}};
    const Reference hit = ask(head_on);
    CHECK(hit.contact);
    CHECK(hit.t == 0.5L);
    CHECK(std::abs(static_cast<double>(hit.closing_speed) - 7) < 1e-9);
    CHECK(!hit.grazing);

    // Passing at a distance of 2 with radii 1 and 1: touches at the middle, exactly.
    const Query tangent{Sphere{1}, {at(-3, 2, 0), Vec3(6, 0, 0)}, Sphere{1}, {at(0, 0, 0)}, {}};
    const Reference touch = ask(tangent);
    CHECK(touch.contact);
    CHECK(touch.grazing);
    CHECK(std::abs(static_cast<double>(touch.t) - 0.5) < 1e-8);

    const Query past{Sphere{1}, {at(-3, 2.25, 0), Vec3(6, 0, 0)}, Sphere{1}, {at(0, 0, 0)}, {}};
    const Reference miss = ask(past);
    CHECK(!miss.contact);
    CHECK(miss.t == 1);
    CHECK(std::abs(static_cast<double>(miss.least_gap) - 0.25) < 1e-2); // exact only near contact

    // A point through a plane, and through a triangle: least gap 0 at one instant.
    const Query point{Sphere{0}, {at(0.25, 0.25, 1), Vec3(0, 0, -4)}, Plane{Vec3(0, 0, 1), 0}, {}, {}};
    CHECK(std::abs(static_cast<double>(ask(point).t) - 0.25) < rounding);
    const Triangle flat{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    const Query sheet{Sphere{0}, {at(0.25, 0.25, 1), Vec3(0, 0, -4)}, flat, {}, {}};
    CHECK(ask(sheet).contact);
    CHECK(std::abs(static_cast<double>(ask(sheet).t) - 0.25) < rounding);
}

TEST_CASE("reference: rotation by hand")
{
    constexpr double pi = 3.14159265358979323846;
    // A needle from the pivot along x turns a half turn about z and meets a point on y: a quarter turn is t =
    // 1/2.
    const Capsule needle{Vec3(0, 0, 0), Vec3(2, 0, 0), 0};
    const Query clock{needle, {at(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, pi)}, Sphere{0}, {at(0, 1, 0)}, {}};
    CHECK(ask(clock).contact);
    CHECK(std::abs(static_cast<double>(ask(clock).t) - 0.5) < 1e-15);

    // With a radius of 1 about the point at distance 2: the needle is tangent at 60 degrees, t = 1/3.
    const Query disc{needle, {at(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, pi)}, Sphere{1}, {at(0, 2, 0)}, {}};
    CHECK(std::abs(static_cast<double>(ask(disc).t) - 1.0 / 3) < 1e-15);

    // A cube turning on the spot above the ground at sqrt(2): touches as its edge comes down, at 45 degrees.
    const Box cube{Vec3(1, 1, 1)};
    const Motion roll{at(0, 0, 1.25), Vec3(0, 0, 0), Vec3(pi / 2, 0, 0)};
    const double lean = std::asin(1.25 / std::sqrt(2.0)) - pi / 4;
    const Query ground{cube, roll, HalfSpace{Vec3(0, 0, 1), 0}, {}, {}};
    CHECK(std::abs(static_cast<double>(ask(ground).t) - lean / (pi / 2)) < 1e-15);

    // The same seen from the ground: the ground turns about the cube's centre the other way.
    const Motion swing{at(0, 0, 0), Vec3(0, 0, 0), Vec3(-pi / 2, 0, 0), Vec3(0, 0, 1.25)};
    const Query seen{cube, {at(0, 0, 1.25)}, HalfSpace{Vec3(0, 0, 1), 0}, swing, {}};
    CHECK(std::abs(static_cast<double>(ask(seen).t) - lean / (pi / 2)) < 1e-15);
}

TEST_CASE("reference: contact at the start")
{
    Query q{Sphere{1}, {at(1.5, 0, 0), Vec3(5, 0, 0)}, Sphere{1}, {}, {}};
    CHECK(ask(q).started);
    CHECK(ask(q).contact);
    CHECK(ask(q).t == 0);
    q.options.start_contact = StartContact::ignore;
    CHECK(!ask(q).contact);
    CHECK(ask(q).left);
    CHECK(ask(q).drop == 0);
    q.motion_a.translation = Vec3(-5, 0, 0); // through the other side
    CHECK(!ask(q).contact);
    CHECK(ask(q).drop > 1.4L);
    // A needle lifts off the ground and comes down on the other side, a half turn later.
    constexpr double pi = 3.14159265358979323846;
    const Motion turn{at(0, 0, 0), Vec3(0, 0, 1), Vec3(0, 1.5 * pi, 0)};
    Query fall{Capsule{Vec3(-1, 0, 0), Vec3(0, 0, 0), 0}, turn, HalfSpace{Vec3(0, 0, 1), 0}, {}, {}};
    fall.options.start_contact = StartContact::ignore;
    CHECK(ask(fall).left);
}

TEST_CASE("reference: the walk and the convex search agree on translation")
{
    int hits = 0;
    int cases = 0;
    for (const Pair& pair : all_pairs()) {
        if (!pair.has_reference()) continue;
        for (std::uint64_t i = 0; i < 60; ++i) {
            const Query q = query(pair, Family::translation, 20261201, i);
            const GapOverTime motion(q);
            const Reference convex = reference(q, motion);
            if (convex.started) continue;
            const Reference walked = reference_walk(q, motion, 0);
            CAPTURE(pair.name());
            CAPTURE(i);
            ++cases;
            CHECK(walked.contact == convex.contact);
            CHECK(!walked.gave_up);
            if (!convex.contact || !walked.contact) continue;
            ++hits;
            CHECK(std::abs(motion.at(walked.t).gap - motion.at(convex.t).gap) <= 4 * blur(motion));
            if (convex.grazing) continue;
            CHECK(std::abs(walked.t - convex.t) <= 1e-18L + 4 * blur(motion) / convex.closing_speed);
        }
    }
    CHECK(cases > 700);
    CHECK(hits > 250);
    CHECK(hits < cases - 250);
}

TEST_CASE("reference: its sine is the C library's but for the last bits")
{
    Random random(20261122);
    for (const double most : {1e-8, 1.0, 30.0, 1048576.0}) {
        for (int i = 0; i < 20000; ++i) {
            const Real high = random.between(-most, most);
            const Real low = random.between(-1, 1);
            const Real angle = high + 0x1p-54L * most * low;
            REQUIRE(std::abs(sine(angle) - std::sin(angle)) <= 0x1p-62L);
        }
    }
}
