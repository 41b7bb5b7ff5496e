// SPDX-License-Identifier: BSD-3-Clause
#include "draw.h"
#include "placed_shape.h"
#include "support.h"

#include <brink/distance.h>
#include <brink/ray.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace brink;
using support::Random;

namespace {

double gap_at(const Vec3& p, const Shape& shape, const Pose& pose)
{
    return distance(Sphere{0}, {p, Quat(1, 0, 0, 0)}, shape, pose).gap;
}

Vec3 along(const Vec3& origin, const Vec3& direction, double t)
{
    return store(load(origin) + t * load(direction));
}

Hull hull_of(const Box& box)
{
    std::vector<Vec3> points;
    for (int k = 0; k < 8; ++k)
        points.push_back(store(corner(core(box), k)));
    return Hull::from_points(points);
}

struct Cast {
    Vec3 origin, direction;
};

/// From outside of a ball of radius 3, at something within 1.2 of the centre.
Cast cast(Random& random)
{
    const Vec3 from = random.between(2, 5) * random.unit(), at = random.in_cube(1.2);
    const double length = random.log_between(0.1, 10);
    return {from, length * Vec3(at - from)};
}

} // namespace

TEST_CASE("ray: cylinders, cones, ellipsoids and hulls are met where the distance first is zero")
{
    Random random(101);
    int hits = 0, misses = 0, inside = 0;
    for (int i = 0; i < 8'000; ++i) {
        const Shape shape =
            support::draw_shape(random, 6 + static_cast<std::size_t>(i % 4), support::ShapeStyle::any);
        const Quat turn = support::draw_orientation(random);
        const Pose pose{random.in_cube(1), turn};
        const Cast c = cast(random);
        const bool within = random.chance(0.05);
        const Vec3 origin = within ? pose.position : c.origin;
        const RayHit hit = ray_cast(origin, c.direction, shape, pose, 100);
        CAPTURE(i);
        REQUIRE(hit.status != Status::invalid);
        if (hit.status == Status::touching) {
            CHECK(gap_at(origin, shape, pose) <= 0);
            ++inside;
            continue;
        }
        const double until = hit.status == Status::hit ? hit.t : 10 / norm(load(c.direction));
        for (int k = 0; k < 20; ++k)
            CHECK(gap_at(along(origin, c.direction, until * k / 20), shape, pose) > 0);
        if (hit.status == Status::separated) {
            ++misses;
            continue;
        }
        const double off = norm(load(hit.point) - load(along(origin, c.direction, hit.t)));
        CHECK(off <= 1e-8); // grazing: the time is known to half of the digits
        CHECK(std::fabs(gap_at(hit.point, shape, pose)) <= 1e-12);
        CHECK(std::fabs(norm(load(hit.normal)) - 1) <= 1e-15);
        CHECK(dot(load(hit.normal), load(c.direction)) <= 0);
        ++hits;
    }
    CHECK(hits > 1'000);
    CHECK(misses > 1'500);
    CHECK(inside > 100);
}

TEST_CASE("ray: the normal is that of the supporting plane")
{
    Random random(102);
    int hits = 0;
    for (int i = 0; i < 4'000; ++i) {
        const Shape shape =
            support::draw_shape(random, 6 + static_cast<std::size_t>(i % 4), support::ShapeStyle::any);
        const Pose pose{random.in_cube(1), random.rotation()};
        const Cast c = cast(random);
        const RayHit hit = ray_cast(c.origin, c.direction, shape, pose);
        const double slope = dot(load(hit.normal), load(c.direction)) / norm(load(c.direction));
        if (hit.status != Status::hit || slope > -1e-3) continue;
        const PlacedShape b = placed_shape(shape, pose, load(hit.point));
        CAPTURE(i);
        CHECK(interval(b.core, load(hit.normal)).high <= 1e-9);
        ++hits;
    }
    CHECK(hits > 300);
}

TEST_CASE("ray: a ball as ellipsoid, a box as hull")
{
    Random random(103);
    int hits = 0;
    for (int i = 0; i < 4'000; ++i) {
        const double r = random.between(0.1, 1), x = random.between(0, 1), y = random.between(0.01, 1);
        const Box box{{x, y, r}};
        const Pose pose{random.in_cube(1), random.rotation()};
        const Cast c = cast(random);
        const RayHit ball = ray_cast(c.origin, c.direction, Sphere{r}, pose);
        const RayHit round = ray_cast(c.origin, c.direction, Ellipsoid{{r, r, r}}, pose);
        const RayHit sharp = ray_cast(c.origin, c.direction, box, pose);
        const RayHit hull = ray_cast(c.origin, c.direction, hull_of(box), pose);
        CAPTURE(i);
        CHECK(round.status == ball.status);
        CHECK(hull.status == sharp.status);
        const double speed = norm(load(c.direction));
        if (ball.status == Status::hit && dot(load(ball.normal), load(c.direction)) < -1e-3 * speed)
            CHECK(std::fabs(round.t - ball.t) * speed <= 1e-12);
        if (sharp.status != Status::hit || dot(load(sharp.normal), load(c.direction)) > -1e-3 * speed)
            continue;
        CHECK(std::fabs(hull.t - sharp.t) * speed <= 1e-11);
        ++hits;
    }
    CHECK(hits > 500);
}

TEST_CASE("ray: exact cases")
{
    const Pose at;
    const auto t = [&](const Vec3& from, const Vec3& by, const Shape& shape) {
        const RayHit hit = ray_cast(from, by, shape, at);
        return hit.status == Status::hit ? hit.t : infinity;
    };
    CHECK(t({0, 0, 4}, {0, 0, -4}, Cylinder{1, 2}) == 0.75);
    CHECK(t({4, 0, 0}, {-4, 0, 0}, Cylinder{1, 2}) == 0.5);
    CHECK(t({4, 0, 1}, {-4, 0, 0}, Cylinder{1, 2}) == 0.5); // along a cap
    CHECK(t({4, 0, 1.5}, {-4, 0, 0}, Cylinder{1, 2}) == infinity);
    CHECK(t({4, 0, 0}, {-4, 0, 0}, Cone{1, 2}) == 0.75);
    CHECK(t({0, 0, 5}, {0, 0, -8}, Cone{1, 2}) == 0.5); // at the apex
    CHECK(t({0.5, 0, -5}, {0, 0, 8}, Cone{1, 2}) == 0.5);
    CHECK(t({3, 0, -5}, {0, 0, 8}, Cone{1, 2}) == infinity);
    CHECK(t({4, 0, 3}, {-4, 0, 0}, Cone{1, 2}) == infinity); // the other half of the double cone
    CHECK(t({0, 0, 5}, {0, 0, -8}, Ellipsoid{{2, 3, 1}}) == 0.5);
    CHECK(t({0, 0, 1}, {0, 0, -2}, Ellipsoid{{2, 3, 0}}) == 0.5); // a disc
    CHECK(t({0, 0, 1}, {0, 0, -2}, Cylinder{0, 2}) == 0.5);
    CHECK(t({0, 0, 1}, {0, 0, -2}, Cone{0, 2}) == 0.5);
    CHECK(t({3, 0, 0}, {-4, 0, 0}, Cylinder{0, 1}) == 0.5); // in its plane
    const std::vector<Vec3> square{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    CHECK(t({0.25, 0.5, 1}, {0, 0, -2}, Hull::from_points(square)) == 0.5); // flat
    CHECK(t({3, 0.5, 0}, {-4, 0, 0}, Hull::from_points(square)) == 0.5);
    CHECK(t({3, 0.5, 0.1}, {-4, 0, 0}, Hull::from_points(square)) == infinity);
}
