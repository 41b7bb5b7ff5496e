// SPDX-License-Identifier: BSD-3-Clause
#include "placed_shape.h"
#include "solid_cores.h"

#include <brink/overlap.h>
#include <brink/toi.h>
#include <doctest/doctest.h>

using namespace brink;
using support::Random;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// A point of a shape's surface, from two numbers in [0, 1) and a direction.
V3 surface_point(const Core& c, double u, V3 way)
{
    const V3 h = c.half_extents;
    if (c.kind == Core::Kind::ellipsoid) return {h.x * way.x, h.y * way.y, h.z * way.z};
    const double across = std::sqrt(way.x * way.x + way.y * way.y), z = h.z * (2 * u - 1);
    const double r = c.kind == Core::Kind::cylinder ? h.x : h.x * (1 - u);
    return {r * way.x / across, r * way.y / across, z};
}

} // namespace

TEST_CASE("support: no point of the surface lies farther, and the one found is one")
{
    SolidCores cores(111);
    Random& random = cores.random;
    for (int i = 0; i < 20'000; ++i) {
        const Core c = cores.local(i % 3);
        const double length = random.log_between(1e-180, 1e180), u = random.between(0, 1);
        const V3 d = length * load(random.unit()), way = load(random.unit());
        const double size = extent(c) * length;
        const Interval reach = interval(c, d);
        CAPTURE(i);
        CHECK(dot(surface_point(c, u, way), d) <= reach.high + 4 * eps * size);
        CHECK(dot(surface_point(c, u, way), d) >= reach.low - 4 * eps * size);
        CHECK(std::fabs(dot(farthest(c, d).point, d) - reach.high) <= 4 * eps * size);
        CHECK(std::fabs(dot(farthest(c, -d).point, d) - reach.low) <= 4 * eps * size);
        CHECK(norm(farthest(c, d).point) <= brink::reach(c) * (1 + 4 * eps));
    }
}

TEST_CASE("support: along a coordinate axis exactly")
{
    CHECK(interval(core(Cylinder{2, 3}), {0, 0, 1}).high == 2);
    CHECK(interval(core(Cylinder{2, 3}), {1, 0, 0}).low == -3);
    CHECK(interval(core(Cone{2, 3}), {0, 0, 1}).high == 2);
    CHECK(interval(core(Cone{2, 3}), {0, 0, 1}).low == -2);
    CHECK(interval(core(Cone{2, 3}), {0, 1, 0}).high == 3);
    CHECK(interval(core(Ellipsoid{{0.1, 0.2, 0.3}}), {0, 1, 0}).high == 0.2);
    CHECK(farthest(core(Ellipsoid{}), {0, 0, 1}).point == V3{});
    CHECK(farthest(core(Cylinder{0, 0}), {1, 2, 3}).point == V3{});
}

TEST_CASE("bounds: hold every supporting point, and no more than rounding besides")
{
    Random random(112);
    for (int i = 0; i < 4'000; ++i) {
        const Shape shape =
            support::draw_shape(random, 6 + static_cast<std::size_t>(i % 4), support::ShapeStyle::any);
        const Quat turn = support::draw_orientation(random);
        const Pose pose{random.in_cube(i % 2 == 0 ? 1 : 1e6), turn};
        const Aabb box = bounds(shape, pose);
        const Core c = placed_shape(shape, pose, {}).core;
        const double rounding = 64 * eps * (extent(c) + 4);
        CAPTURE(i);
        for (int k = 0; k < 3; ++k) {
            const V3 axis{k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0};
            const Interval reach = interval(c, axis);
            CHECK(box.max[k] >= reach.high - 2 * eps * extent(c));
            CHECK(box.max[k] <= reach.high + rounding);
            CHECK(box.min[k] <= reach.low + 2 * eps * extent(c));
            CHECK(box.min[k] >= reach.low - rounding);
        }
    }
    const Aabb exact = bounds(Cylinder{2, 3}, Pose{{1, 1, 1}, Quat(1, 0, 0, 0)});
    CHECK(exact.max == Vec3(4, 4, 3));
    CHECK(exact.min == Vec3(-2, -2, -1));
    CHECK(bounds(Ellipsoid{{0.1, 1e-200, 1e200}}, Pose{}).max == Vec3(0.1, 1e-200, 1e200));
    CHECK(bounds(Cylinder{-1, 1}, Pose{}).max.x() == infinity);
}

TEST_CASE("swept bounds: hold the shape at every time")
{
    Random random(113);
    for (int i = 0; i < 2'000; ++i) {
        const Shape shape =
            support::draw_shape(random, 6 + static_cast<std::size_t>(i % 4), support::ShapeStyle::any);
        Motion m;
        m.start = {random.in_cube(1), random.rotation()};
        m.translation = random.in_cube(2);
        m.rotation = random.in_cube(3);
        m.pivot = random.in_cube(1);
        const Aabb all = swept_bounds(shape, m);
        for (int k = 0; k <= 16; ++k) {
            const Aabb now = bounds(shape, m.at(k / 16.0));
            CHECK((now.min.array() >= all.min.array() - 1e-12).all());
            CHECK((now.max.array() <= all.max.array() + 1e-12).all());
        }
    }
}

TEST_CASE("planes and half-spaces against the new shapes: by their supporting points; overlaps agrees")
{
    Random random(114);
    int through = 0;
    for (int i = 0; i < 4'000; ++i) {
        const Shape shape =
            support::draw_shape(random, 6 + static_cast<std::size_t>(i % 4), support::ShapeStyle::any);
        const Pose pose{random.in_cube(1), random.rotation()}, level{random.in_cube(1), random.rotation()};
        const Vec3 normal = random.unit();
        const double offset = random.between(-0.5, 0.5);
        const Core c = placed_shape(shape, pose, {}).core;
        const Border b = placed_shape(Plane{normal, offset}, level, {}).border;
        const Interval reach = interval(c, b.normal);
        const double above = reach.low - b.offset, below = b.offset - reach.high;
        const Distance solid = distance(shape, pose, HalfSpace{normal, offset}, level);
        const Distance thin = distance(Plane{normal, offset}, level, shape, pose);
        CAPTURE(i);
        CHECK(std::fabs(solid.gap - above) <= 1e-14);
        CHECK(std::fabs(thin.gap - std::max(above, below)) <= 1e-14);
        CHECK(overlaps(shape, pose, HalfSpace{normal, offset}, level) == (solid.gap <= 0));
        CHECK((solid.point_b - solid.point_a - solid.gap * solid.normal).norm() <= 1e-14);
        through += thin.gap < 0;
    }
    CHECK(through > 1'000);
}

TEST_CASE("extreme lengths: distances of the new shapes scale")
{
    Random random(115);
    for (int i = 0; i < 400; ++i) {
        const std::vector<Vec3> corners{random.unit(), random.unit(), random.unit(), random.unit(),
                                        random.unit()};
        const Pose pose{2.5 * random.unit(), random.rotation()};
        const double plain = distance(Hull::from_points(corners), Pose{}, Cylinder{0.5, 0.25}, pose).gap;
        for (const int e : {-900, -300, 300, 900}) {
            const double unit = std::ldexp(1, e);
            std::vector<Vec3> scaled;
            for (const Vec3& p : corners)
                scaled.push_back(unit * p);
            const Pose far{unit * pose.position, pose.orientation};
            const double gap =
                distance(Hull::from_points(scaled), Pose{}, Cylinder{0.5 * unit, 0.25 * unit}, far).gap;
            CAPTURE(e);
            CHECK(gap == unit * plain);
        }
    }
}
