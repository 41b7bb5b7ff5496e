// SPDX-License-Identifier: BSD-3-Clause
#include "random.h"

#include <brink/distance.h>
#include <doctest/doctest.h>

using namespace brink;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double eps = std::numeric_limits<double>::epsilon();

double dot(const Vec3& a, const Vec3& b) { return a.x() * b.x() + a.y() * b.y() + a.z() * b.z(); }
double norm(const Vec3& a) { return std::sqrt(dot(a, a)); }
Pose at(double x, double y, double z) { return {{x, y, z}, Quat(1, 0, 0, 0)}; }

Shape draw(support::Random& random, int kind)
{
    const double r = random.between(0, 1), offset = random.between(-1, 1);
    const Vec3 p = random.in_cube(1), q = random.in_cube(1), s = random.in_cube(1), n = random.unit();
    switch (kind) {
    case 0:
        return Sphere{r};
    case 1:
        return Capsule{p, q, r};
    case 2:
        return Box{p.cwiseAbs()};
    case 3:
        return Triangle{p, q, s};
    case 4:
        return Plane{n, offset};
    default:
        return HalfSpace{n, offset};
    }
}

} // namespace

TEST_CASE("distance: by hand, one of each against a ball")
{
    const Shape ball = Sphere{1};
    CHECK(distance(ball, at(0, 0, 0), Sphere{2}, at(7, 0, 0)).gap == 4);
    CHECK(distance(ball, at(0, 0, 0), Capsule{{5, -1, 0}, {5, 1, 0}, 0.5}, Pose{}).gap == 3.5);
    CHECK(distance(ball, at(0, 4, 0), Box{{1, 1, 1}}, Pose{}).gap == 2);
    CHECK(distance(ball, at(0, 0, 4), Triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, Pose{}).gap == 3);
    CHECK(distance(ball, at(0, 0, 4), Plane{{0, 0, 1}, -1}, Pose{}).gap == 4);
    CHECK(distance(ball, at(0, 0, 4), HalfSpace{{0, 0, 1}, -1}, Pose{}).gap == 4);
    CHECK(distance(ball, at(0, 0, -4), HalfSpace{{0, 0, 1}, -1}, Pose{}).gap == -4);

    const Distance d = distance(Plane{{0, 0, 1}, 0}, at(0, 0, -1), ball, at(3, 0, 4));
    CHECK(d.status == Status::separated);
    CHECK(d.gap == 4);
    CHECK(d.normal == Vec3(0, 0, 1)); // from the plane towards the ball
    CHECK(d.point_a == Vec3(3, 0, -1));
    CHECK(d.point_b == Vec3(3, 0, 3));
}

TEST_CASE("distance: touching is gap <= 0")
{
    CHECK(distance(Sphere{1}, Pose{}, Sphere{2}, at(3, 0, 0)).status == Status::touching);
    CHECK(distance(Sphere{1}, Pose{}, Sphere{2}, at(3 + 4 * eps, 0, 0)).status == Status::separated);
    CHECK(distance(Sphere{}, Pose{}, Sphere{}, Pose{}).status == Status::touching);
}

TEST_CASE("distance: turned bodies")
{
    const double half = std::sqrt(0.5);
    const Pose upright{{0, 0, 10}, Quat(half, 0, half, 0)}; // x to -z
    const Distance d = distance(Box{{4, 1, 1}}, upright, HalfSpace{}, Pose{});
    CHECK(std::fabs(d.gap - 6) <= 8 * eps);
    const Pose longer{{0, 0, 10},
                      Quat(half * (1 + 4e-7), 0, half * (1 + 4e-7), 0)}; // a float's unit quaternion
    CHECK(std::fabs(distance(Box{{4, 1, 1}}, longer, HalfSpace{}, Pose{}).gap - 6) <= 8 * eps);
}

TEST_CASE("distance: every pair keeps its promises; exchanged, the sides are exchanged")
{
    support::Random random(20261122);
    int separated = 0, touching = 0;
    for (int i = 0; i < 36'000; ++i) {
        const int kind_a = i % 6, kind_b = i / 6 % 6;
        const Shape a = draw(random, kind_a), b = draw(random, kind_b);
        const Vec3 p = random.in_cube(2), q = random.in_cube(2);
        const Quat turn_a = random.rotation(), turn_b = random.rotation();
        const Distance d = distance(a, {p, turn_a}, b, {q, turn_b}),
                       e = distance(b, {q, turn_b}, a, {p, turn_a});
        CAPTURE(i);
        if (kind_a >= 4 && kind_b >= 4) {
            CHECK(d.status == Status::invalid);
            CHECK(std::isnan(d.gap));
            continue;
        }
        CHECK(d.status == (d.gap > 0 ? Status::separated : Status::touching));
        CHECK(std::fabs(norm(d.normal) - 1) <= 8 * eps);
        CHECK(norm(d.point_b - d.point_a - d.gap * d.normal) <= 1e-13);
        CHECK(std::fabs(d.gap - e.gap) <= 1e-13);
        // Each witness point lies on its shape, by the distance of a point.
        CHECK(std::fabs(distance(Sphere{}, {d.point_a, turn_a}, a, {p, turn_a}).gap) <=
              (d.gap > 0 ? 1e-13 : 3));
        CHECK(std::fabs(distance(Sphere{}, {d.point_b, turn_a}, b, {q, turn_b}).gap) <=
              (d.gap > 0 ? 1e-13 : 9));
        separated += d.gap > 0;
        touching += d.gap <= 0;
    }
    CHECK(separated > 10'000);
    CHECK(touching > 5'000);
}

TEST_CASE("distance: shrinking by the gap leaves the two touching")
{
    // Along the normal by the gap, whatever its sign: then nothing is left between them.
    support::Random random(8);
    int overlapping = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Shape a = draw(random, i % 4), b = draw(random, i / 4 % 6);
        const Vec3 p = random.in_cube(2), q = random.in_cube(2);
        const Quat turn_a = random.rotation(), turn_b = random.rotation();
        const Distance d = distance(a, {p, turn_a}, b, {q, turn_b});
        const Vec3 moved = q - d.gap * d.normal;
        CAPTURE(i);
        CHECK(std::fabs(distance(a, {p, turn_a}, b, {moved, turn_b}).gap) <= 1e-13);
        overlapping += d.gap < 0;
    }
    CHECK(overlapping > 3'000);
}

TEST_CASE("distance: a common offset costs nothing")
{
    support::Random random(9);
    int compared = 0;
    for (int i = 0; i < 6'000; ++i) {
        const Shape a = draw(random, i % 4), b = draw(random, i / 4 % 6);
        const Quat turn_a = random.rotation(), turn_b = random.rotation();
        // Positions on a grid of 2^-10, so that adding 2^30 to them is exact.
        const double x = random.index(4096), y = random.index(4096), z = random.index(4096);
        const Vec3 q = Vec3(x, y, z) * 0x1p-10, far(0x1p30, -0x1p31, 0x1p29), origin(0, 0, 0);
        if (std::holds_alternative<Plane>(b) || std::holds_alternative<HalfSpace>(b)) continue;
        const double near_gap = distance(a, {origin, turn_a}, b, {q, turn_b}).gap;
        CHECK(distance(a, {origin + far, turn_a}, b, {q + far, turn_b}).gap == near_gap);
        ++compared;
    }
    CHECK(compared > 3'500);
}

TEST_CASE("distance: the ends of the exponent range")
{
    const Distance far = distance(Sphere{1}, at(1.5e308, 0, 0), Sphere{1e307}, at(-1.5e307, 0, 0));
    CHECK(std::fabs(far.gap / 1.55e308 - 1) <= 4 * eps);
    CHECK(far.normal == Vec3(-1, 0, 0));
    const Distance beyond = distance(Sphere{1}, at(1.5e308, 0, 0), Sphere{1}, at(-1.5e308, 0, 0));
    CHECK(beyond.gap == infinity); // 3e308 is no double
    CHECK(beyond.normal == Vec3(-1, 0, 0));
    const Distance tiny =
        distance(Box{{1e-300, 1e-300, 1e-300}}, Pose{}, Box{{1e-300, 1e-300, 1e-300}}, at(3e-300, 0, 0));
    CHECK(std::fabs(tiny.gap - 1e-300) <= 4 * eps * 3e-300);
    const Distance huge = distance(Box{{1e300, 1e300, 1e300}}, Pose{},
                                   Capsule{{0, 0, 0}, {0, 1e290, 0}, 1e299}, at(3e300, 0, 0));
    CHECK(std::fabs(huge.gap - 1.9e300) <= 8 * eps * 3e300);
}

TEST_CASE("distance: bad input is invalid, and a sphere's orientation is not looked at")
{
    const Shape box = Box{{1, 1, 1}};
    for (const Distance& d :
         {distance(box, at(not_a_number, 0, 0), box, Pose{}), distance(box, Pose{}, Box{{1, -1, 1}}, Pose{}),
          distance(box, {{0, 0, 0}, Quat(0, 0, 0, 0)}, box, Pose{}),
          distance(Plane{}, Pose{}, HalfSpace{}, Pose{}),
          distance(Plane{{0, 0, 2}, 0}, Pose{}, box, Pose{})}) {
        CHECK(d.status == Status::invalid);
        CHECK(std::isnan(d.gap));
        CHECK(d.normal == Vec3(0, 0, 0));
    }
    const Distance d = distance(Sphere{1}, {{4, 0, 0}, Quat(not_a_number, 0, 0, 0)}, box, Pose{});
    CHECK(d.status == Status::separated);
    CHECK(d.gap == 2);
}
