// SPDX-License-Identifier: BSD-3-Clause
#include "advance.h"
#include "point_path.h"
#include "two_bodies.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace brink;
using support::Random;

namespace {

struct Tally {
    int hits = 0, separated = 0, left = 0, proven = 0, misses_by_a_hair = 0;
};

/// Held against the distance at many times and against the general advancement.
template <class S>
void check_passing(const Sphere& sphere, const Motion& a, const S& shape, const Motion& b, Tally& tally)
{
    const TwoBodies<Core> bodies{mover(sphere, a), mover(shape, b)};
    const Options options;
    const double rounding = 1e-12;
    const Toi toi = pass(sphere, a, shape, b, options);
    CHECK(toi.iterations <= 24 + 1); // tolerance::most_passing, and the look that tells
    if (toi.status == Status::invalid) {
        ++tally.left;
        return;
    }
    const bool hit = toi.status == Status::hit;
    CHECK((hit || (toi.status == Status::separated && toi.t == 1)));
    ++(hit ? tally.hits : tally.separated);
    double least = infinity;
    for (int k = 0; k <= 200; ++k)
        least = std::fmin(least, bodies.at(toi.t * k / 200).gap);
    CHECK(least >= -rounding);
    tally.misses_by_a_hair += !hit && least < 0.01 ? 1 : 0;
    const Toi other = certified_advancement(bodies.a, bodies.b, options, {{sphere, a, shape, b, options}});
    if (least > 2 * options.tolerance || hit) CHECK(other.status == toi.status);
    if (!hit) return;
    CHECK(bodies.at(toi.t).gap <= options.tolerance + rounding);
    CHECK(std::fabs(bodies.at(toi.t).gap - toi.gap) <= rounding);
    CHECK((toi.point_b - toi.point_a - toi.gap * toi.normal).norm() <= rounding);
    if (toi.t > 0.01 && other.t_upper < infinity) CHECK(toi.t <= other.t_upper);
    Options at_t = options;
    at_t.t_max = toi.t;
    CHECK(pass(sphere, a, shape, b, at_t).status == Status::hit);
    if (toi.t_upper == infinity) return;
    ++tally.proven;
    CHECK(toi.t_upper >= toi.t);
    CHECK(bodies.at(toi.t_upper).gap <= rounding);
}

template <class S, class Draw> void check_shape(std::uint64_t seed, Draw draw)
{
    Random random(seed);
    Tally tally;
    for (int i = 0; i < 4'000; ++i) {
        CAPTURE(seed);
        CAPTURE(i);
        const Sphere sphere{random.log_between(0.01, 1)};
        const S shape = draw(random);
        Motion a = random_motion(random, 3), b = random_motion(random, 3);
        a.pivot = Vec3(0, 0, 0);
        if (random.chance(0.1)) b.rotation = Vec3(0, 0, 0);
        if (random.chance(0.1)) b.rotation = Vec3(10 * b.rotation.x(), 10 * b.rotation.y(), 0);
        b.translation = a.start.position + a.translation - b.start.position + random.in_cube(1.5);
        check_passing(sphere, a, shape, b, tally);
    }
    CHECK(tally.hits > 500);
    CHECK(tally.separated > 500);
    CHECK(tally.misses_by_a_hair > 3);
    CHECK(tally.left > 20);
    CHECK(tally.proven > tally.hits * 9 / 10);
}

} // namespace

TEST_CASE("pass: a hit is within the tolerance of contact and nothing before it is in contact")
{
    check_shape<Capsule>(1, [](Random& r) {
        const Vec3 from = r.in_cube(1), to = r.in_cube(1);
        return Capsule{from, to, r.log_between(0.01, 0.5)};
    });
    check_shape<Triangle>(2, [](Random& r) {
        const Vec3 a = r.in_cube(1), b = r.in_cube(1), c = r.in_cube(1);
        return Triangle{a, b, c};
    });
    check_shape<Box>(3, [](Random& r) { return Box{r.in_cube(1).cwiseAbs()}; });
    check_shape<Cylinder>(4, [](Random& r) {
        const double length = r.between(0, 1), radius = r.between(0, 1);
        return Cylinder{length, radius};
    });
    check_shape<Cone>(5, [](Random& r) {
        const double length = r.between(0, 1), radius = r.between(0, 1);
        return Cone{length, radius};
    });
}

TEST_CASE("pass: a box that sweeps round meets a sphere at rest where its corner does")
{
    // The corner at (3, 4) goes round on a circle of radius 5, about z from atan(4 / 3) on; the sphere of
    // radius 1 about (0, 6) is met where the corner comes by x = 0.
    Motion turning;
    turning.rotation = Vec3(0, 0, 3.14159265358979324);
    Motion still;
    still.start.position = Vec3(0, 6, 0);
    const Toi toi = pass(Sphere{1}, still, Box{Vec3(3, 4, 1)}, turning, Options{});
    REQUIRE(toi.status == Status::hit);
    const double contact = (3.14159265358979324 / 2 - std::atan2(4.0, 3.0)) / 3.14159265358979324;
    CHECK(toi.t <= contact);
    CHECK(contact - toi.t < 1e-4); // grazing: there the corner moves across the normal
    CHECK((toi.normal - Vec3(0, -1, 0)).norm() < 1e-3);
}

TEST_CASE("pass: leaves to the general advancement what begins near contact or has no radius")
{
    Motion turning;
    turning.rotation = Vec3(0, 0, 1);
    Motion away;
    away.start.position = Vec3(2, 0, 0);
    const Box box{Vec3(1, 1, 1)};
    CHECK(pass(Sphere{1}, away, box, turning, Options{}).status == Status::invalid);
    CHECK(pass(Sphere{1.5}, away, box, turning, Options{}).status == Status::invalid);
    CHECK(pass(Sphere{0}, away, box, turning, Options{}).status == Status::invalid);
    CHECK(pass(Sphere{0.25}, away, box, turning, Options{}).status == Status::separated);
}
