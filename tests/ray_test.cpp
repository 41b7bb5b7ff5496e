// SPDX-License-Identifier: BSD-3-Clause
#include "random.h"
#include "vector.h"

#include <brink/distance.h>
#include <brink/ray.h>
#include <doctest/doctest.h>

using namespace brink;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double eps = std::numeric_limits<double>::epsilon();
const Triangle corner{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

struct Expected {
    double t;
    Vec3 point, normal;
};

void check_hit(const RayHit& hit, const Expected& expected)
{
    CHECK(hit.status == Status::hit);
    CHECK(std::fabs(hit.t - expected.t) <= 4 * eps * expected.t);
    CHECK((hit.point - expected.point).norm() <= 16 * eps);
    CHECK((hit.normal - expected.normal).norm() <= 16 * eps);
}

double gap_at(const Vec3& p, const Shape& shape, const Pose& pose)
{
    return distance(Sphere{}, {p, Quat(1, 0, 0, 0)}, shape, pose).gap;
}

Shape draw(support::Random& random, int kind)
{
    const double r = random.between(0, 1), offset = random.between(-1, 1);
    const Vec3 p = random.in_cube(1), q = random.in_cube(1), s = random.in_cube(1), n = random.unit();
    switch (kind) {
    case 0:
        return Sphere{r};
    case 1:
        return Capsule{p, q, r / 2};
    case 2:
        return Box{p.cwiseAbs()};
    case 3:
        return Triangle{2 * p, 2 * q, 2 * s};
    case 4:
        return Plane{n, offset};
    default:
        return HalfSpace{n, offset};
    }
}

/// How near the ray comes to the shape, by golden sections of a convex function: the distance to a convex
/// set.
double nearest_approach(const Vec3& from, const Vec3& by, const Shape& shape, const Pose& pose, double t_max)
{
    double low = 0, high = t_max;
    for (int k = 0; k < 90; ++k) {
        const double one = low + 0.382 * (high - low), other = low + 0.618 * (high - low);
        if (gap_at(from + one * by, shape, pose) <= gap_at(from + other * by, shape, pose))
            high = other;
        else
            low = one;
    }
    return gap_at(from + low * by, shape, pose);
}

} // namespace

TEST_CASE("ray: one of each, head on")
{
    check_hit(ray_cast({5, 0, 0}, {-8, 0, 0}, Sphere{1}, Pose{}), {0.5, {1, 0, 0}, {1, 0, 0}});
    check_hit(ray_cast({5, 0.5, 0}, {-8, 0, 0}, Capsule{{0, -1, 0}, {0, 1, 0}, 1}, Pose{}),
              {0.5, {1, 0.5, 0}, {1, 0, 0}});
    check_hit(ray_cast({0, 6, 0}, {0, -8, 0}, Capsule{{0, -1, 0}, {0, 1, 0}, 1}, Pose{}),
              {0.5, {0, 2, 0}, {0, 1, 0}});
    check_hit(ray_cast({0.5, 6, 0}, {0, -8, 0}, Box{{1, 2, 3}}, Pose{}), {0.5, {0.5, 2, 0}, {0, 1, 0}});
    check_hit(ray_cast({1, 1, -2}, {0, 0, 8}, corner, Pose{}), {0.25, {1, 1, 0}, {0, 0, -1}});
    check_hit(ray_cast({1, 1, 2}, {0, 0, -8}, corner, Pose{}), {0.25, {1, 1, 0}, {0, 0, 1}});
    check_hit(ray_cast({1, 1, 2}, {1, 0, -4}, Plane{}, Pose{}), {0.5, {1.5, 1, 0}, {0, 0, 1}});
    check_hit(ray_cast({1, 1, -2}, {1, 0, 4}, Plane{}, Pose{}), {0.5, {1.5, 1, 0}, {0, 0, -1}});
    check_hit(ray_cast({1, 1, 2}, {1, 0, -4}, HalfSpace{}, Pose{}), {0.5, {1.5, 1, 0}, {0, 0, 1}});
    CHECK(ray_cast({1, 1, 2}, {1, 0, 4}, HalfSpace{}, Pose{}, infinity).status == Status::separated);
}

TEST_CASE("ray: t in lengths of the direction, up to t_max")
{
    const Vec3 from(5, 0, 0), by(-1, 0, 0);
    const RayHit before = ray_cast(from, by, Sphere{1}, Pose{}, 3.75);
    CHECK(before.status == Status::separated);
    CHECK(before.t == 3.75);
    CHECK(before.normal == Vec3(0, 0, 0));
    CHECK(ray_cast(from, by, Sphere{1}, Pose{}, 4).status == Status::hit);
    CHECK(ray_cast(from, by, Sphere{1}, Pose{}, infinity).t == 4);
    CHECK(ray_cast(from, -by, Sphere{1}, Pose{}, infinity).t == infinity);
    CHECK(ray_cast(from, {0, 0, 0}, Sphere{1}, Pose{}).status == Status::separated);
    CHECK(ray_cast({0, 1, 0}, {0, 0, 0}, Sphere{1}, Pose{}).status == Status::touching);
}

TEST_CASE("ray: from inside, or from the surface, it touches at once and the normal leads out")
{
    const RayHit inside = ray_cast({0.75, 0, 0}, {1, 1, 1}, Box{{1, 2, 3}}, Pose{});
    CHECK(inside.status == Status::touching);
    CHECK(inside.t == 0);
    CHECK(inside.point == Vec3(0.75, 0, 0));
    CHECK(inside.normal == Vec3(1, 0, 0));
    CHECK(ray_cast({0, 0, 1}, {0, 0, 1}, Sphere{1}, Pose{}).status == Status::touching);
    CHECK(ray_cast({0, 0, 1}, {0, 0, 1}, Sphere{1}, Pose{}).normal == Vec3(0, 0, 1));
    CHECK(ray_cast({3, 3, -5}, {0, 0, 1}, HalfSpace{}, Pose{}).status == Status::touching);
    CHECK(ray_cast({3, 3, 0}, {0, 0, 1}, Plane{}, Pose{}).status == Status::touching);
    CHECK(ray_cast({1, 1, 0}, {0, 0, 1}, corner, Pose{}).status == Status::touching);
}

TEST_CASE("ray: tangency, edges and corners are hits")
{
    CHECK(ray_cast({-5, 1, 0}, {1, 0, 0}, Sphere{1}, Pose{}, infinity).t == 5);
    CHECK(ray_cast({-5, 0.5, 1}, {1, 0, 0}, Capsule{{0, 0, 0}, {0, 1, 0}, 1}, Pose{}, infinity).t == 5);
    CHECK(ray_cast({-5, 1, 1}, {1, 0, 0}, Box{{1, 1, 1}}, Pose{}, infinity).t == 4);
    CHECK(ray_cast({2, 2, 1}, {0, 0, -1}, corner, Pose{}, infinity).t == 1);
    CHECK(ray_cast({0, 0, 1}, {0, 0, -1}, corner, Pose{}, infinity).t == 1);
    CHECK(ray_cast({-5, 1, 0}, {1, 0, 0}, corner, Pose{}, infinity).t == 5); // in its plane, at its edge
    CHECK(ray_cast({-5, 1, 0}, {1, 0, 0}, corner, Pose{}, infinity).normal == Vec3(-1, 0, 0));
    CHECK(ray_cast({-5, 1, 1e-9}, {1, 0, 0}, corner, Pose{}, infinity).status == Status::separated);
    CHECK(ray_cast({-5, 1 + 4 * eps, 0}, {1, 0, 0}, Sphere{1}, Pose{}, infinity).status == Status::separated);
}

TEST_CASE("ray: segments and points are hit if they are met exactly")
{
    const Shape point = Triangle{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}},
                line = Triangle{{0, -1, 0}, {0, 1, 0}, {0, 3, 0}};
    CHECK(ray_cast({0, 0, 0}, {2, 4, 6}, point, Pose{}).t == 0.5);
    CHECK(ray_cast({0, 0, 0}, {2, 4, 6.5}, point, Pose{}).status == Status::separated);
    CHECK(ray_cast({-4, 2, 0}, {8, 0, 0}, line, Pose{}).t == 0.5);
    CHECK(ray_cast({-4, 4, 0}, {8, 0, 0}, line, Pose{}).status == Status::separated);
    CHECK(ray_cast({-4, 2, 0.5}, {8, 0, 0}, line, Pose{}).status == Status::separated);
    CHECK(ray_cast({0, 7, 0}, {0, -8, 0}, line, Pose{}).t == 0.5); // along it
    CHECK(ray_cast({-4, 0, 0}, {8, 0, 0}, Sphere{0}, Pose{}).t == 0.5);
    CHECK(ray_cast({-4, 1, 0}, {8, 0, 0}, Capsule{{0, 0, 0}, {0, 4, 0}, 0}, Pose{}).t == 0.5);
    CHECK(ray_cast({-4, 1, 0}, {8, 0, 0}, Box{{0, 2, 0}}, Pose{}).t == 0.5);
    CHECK(ray_cast({-4, 1, 0}, {8, 0, 0}, Box{{0, 2, 0}}, Pose{}).normal == Vec3(-1, 0, 0));
}

TEST_CASE("ray: apart before t, on the shape at t, and no miss that comes near")
{
    support::Random random(20261122);
    int hits = 0, misses = 0, touching = 0;
    for (int i = 0; i < 24'000; ++i) {
        const Shape shape = draw(random, i % 6);
        const Vec3 at = random.in_cube(1), from = random.in_cube(4), by = random.in_cube(2) - from;
        const Pose pose{at, random.rotation()};
        const RayHit hit = ray_cast(from, by, shape, pose);
        CAPTURE(i);
        if (hit.status == Status::touching) {
            CHECK(gap_at(from, shape, pose) <= 1e-14);
            ++touching;
            continue;
        }
        const double t = std::min(hit.t, 1.0);
        for (int k = 0; k < 16; ++k)
            CHECK(gap_at(from + (t * k / 16) * by, shape, pose) > 0);
        if (hit.status == Status::separated) {
            CHECK(hit.t == 1);
            const bool flat = i % 6 == 4;
            if (!flat) CHECK(nearest_approach(from, by, shape, pose, 1) > 0);
            ++misses;
            continue;
        }
        CHECK((hit.point - (from + hit.t * by)).norm() <= 1e-12);
        CHECK(std::fabs(gap_at(hit.point, shape, pose)) <= 1e-14);
        CHECK(std::fabs(hit.normal.norm() - 1) <= 8 * eps);
        CHECK(hit.normal.dot(by) <= 1e-12);
        // The normal leads away from the shape: just off the surface along it, that is how far off.
        CHECK(std::fabs(gap_at(hit.point + 1e-3 * hit.normal, shape, pose) - 1e-3) <= 1e-13);
        ++hits;
    }
    CHECK(hits > 3'000);
    CHECK(misses > 6'000);
    CHECK(touching > 2'000);
}

TEST_CASE("ray: from far away, and at any scale")
{
    // 1e8 radii away the textbook's b^2 - a c has lost every digit.
    CHECK(std::fabs(ray_cast({1e8, 0.6, 0}, {-1, 0, 0}, Sphere{1}, Pose{}, infinity).t - (1e8 - 0.8)) <=
          1e-7);
    CHECK(ray_cast({1e8, 1.0001, 0}, {-1, 0, 0}, Sphere{1}, Pose{}, infinity).status == Status::separated);
    CHECK((ray_cast({1e8, 0.6, 0}, {-1, 0, 0}, Sphere{1}, Pose{}, infinity).normal - Vec3(0.8, 0.6, 0))
              .norm() <= 1e-7);

    const Shape shapes[] = {Sphere{1},           Capsule{{0, -1, 0}, {0, 1, 0}, 1},
                            Box{{1, 1, 1}},      Triangle{{1, -1, -1}, {1, 2, 0}, {1, 0, 2}},
                            Plane{{1, 0, 0}, 1}, HalfSpace{{1, 0, 0}, 1}};
    const Shape tiny[] = {
        Sphere{0x1p-900},
        Capsule{{0, -0x1p-900, 0}, {0, 0x1p-900, 0}, 0x1p-900},
        Box{{0x1p-900, 0x1p-900, 0x1p-900}},
        Triangle{{0x1p-900, -0x1p-900, -0x1p-900}, {0x1p-900, 0x1p-899, 0}, {0x1p-900, 0, 0x1p-899}},
        Plane{{1, 0, 0}, 0x1p-900},
        HalfSpace{{1, 0, 0}, 0x1p-900}};
    for (int k = 0; k < 6; ++k) {
        CAPTURE(k);
        const RayHit one = ray_cast({7, 0.25, 0.125}, {-3, 0, 0}, shapes[k], Pose{}, infinity);
        const RayHit same =
            ray_cast(Vec3(7, 0.25, 0.125) * 0x1p-900, Vec3(-3, 0, 0) * 0x1p-1000, tiny[k], Pose{}, infinity);
        CHECK(one.status == Status::hit);
        CHECK(same.t == one.t * 0x1p100);
        CHECK(same.normal == one.normal);
    }
    const RayHit across =
        ray_cast({1.5e308, 0, 0}, {-1e308, 0, 0}, Sphere{1e308}, {{-1.5e308, 0, 0}, Quat(1, 0, 0, 0)}, 10);
    CHECK(across.status == Status::hit);
    CHECK(std::fabs(across.t - 2) <= 8 * eps);
}

TEST_CASE("ray: bad input is invalid")
{
    const Vec3 from(5, 0, 0), by(-1, 0, 0), bad(0, not_a_number, 0);
    CHECK(ray_cast(bad, by, Sphere{1}, Pose{}).status == Status::invalid);
    CHECK(ray_cast(from, bad, Sphere{1}, Pose{}).status == Status::invalid);
    CHECK(ray_cast(from, {infinity, 0, 0}, Sphere{1}, Pose{}).status == Status::invalid);
    CHECK(ray_cast(from, by, Sphere{-1}, Pose{}).status == Status::invalid);
    CHECK(ray_cast(from, by, Sphere{1}, Pose{}, -1).status == Status::invalid);
    CHECK(ray_cast(from, by, Sphere{1}, Pose{}, not_a_number).status == Status::invalid);
    CHECK(ray_cast(from, by, Sphere{1}, Pose{}, not_a_number).t == 0);
}
