// SPDX-License-Identifier: BSD-3-Clause
#include "depth.h"
#include "hull_data.h"
#include "solid_cores.h"
#include "support/solid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace brink;
using support::Random;

namespace {

using Real = long double;
using Real3 = support::Vector<Real>;

Real3 real(V3 v) { return {v.x, v.y, v.z}; }

/// How far a point must go to leave a body: the least way to a supporting plane, over directions at random
/// and those of faces, the nearest line of a side among them. Negative outside.
Real way_out(Random& random, const Shape& shape, const Quat& turned, V3 at, V3 point)
{
    const auto solid = support::solid<Real>(shape);
    const auto axes = support::rotation_of<Real>(turned);
    const auto body = support::placed(solid, real(at), axes);
    const Real3 p = real(point), local = support::transposed_times(axes, p - real(at));
    Real least = infinity;
    const auto ask = [&](Real3 n) {
        if (norm(n) > 0) least = std::min(least, dot(n, body.support(n) - p) / norm(n));
    };
    for (const Real3 axis : {axes.x, axes.y, axes.z})
        ask(axis), ask(-axis);
    const Real3 outwards{local.x, local.y, 0};
    ask(axes * outwards);
    ask(axes * (2 * solid.half_length * outwards + Real3{0, 0, solid.girth * norm(outwards)}));
    for (int i = 0; i < 200; ++i)
        ask(real(load(random.unit())));
    return least;
}

struct Sample {
    Shape shape;
    Core local;
    V3 size;
};

/// A box, cylinder, cone or ellipsoid.
Sample solid_shape(SolidCores& draw, int kind)
{
    const double x = draw.size(), y = draw.size(), z = draw.size();
    if (kind == 0) return {Box{{x, y, z}}, core(Box{{x, y, z}}), {x, y, z}};
    if (kind == 1) return {Cylinder{z, x}, core(Cylinder{z, x}), {x, x, z}};
    if (kind == 2) return {Cone{z, x}, core(Cone{z, x}), {x, x, z}};
    return {Ellipsoid{{x, y, z}}, core(Ellipsoid{{x, y, z}}), {x, y, z}};
}

/// How deep a point lies in the hull of corners, by every plane through three of them that has none beyond.
Real depth_in_hull(const std::vector<Real3>& corners, Real3 p)
{
    Real least = infinity;
    for (const Real3& a : corners)
        for (const Real3& b : corners)
            for (const Real3& c : corners) {
                const Real3 n = cross(b - a, c - a);
                const auto beyond = [&](Real3 q) { return dot(n, q - a) > 1e-16L; };
                if (!(norm(n) > 1e-9L) || std::any_of(corners.begin(), corners.end(), beyond)) continue;
                least = std::min(least, dot(n, a - p) / norm(n));
            }
    return least;
}

} // namespace

TEST_CASE("depth: of hulls, no plane of three corners is nearer")
{
    SolidCores draw(94);
    int inside = 0, outside = 0, known = 0;
    for (int i = 0; i < 2'000; ++i) {
        CAPTURE(i);
        const double length = draw.random.chance(0.5) ? 1 : draw.random.log_between(1e-6, 1e6);
        std::vector<Vec3> points;
        std::vector<Real3> corners;
        const Vec3 size = length * Vec3(1, draw.random.log_between(1e-3, 1), draw.random.between(0.1, 1));
        for (int k = 4 + draw.random.index(9); k > 0; --k) {
            points.push_back(draw.random.in_cube(1).cwiseProduct(size));
            corners.push_back((1 / Real{length}) * real(load(points.back())));
        }
        const Hull hull = Hull::from_points(points);
        const Core local = core(hull);
        if (local.hull->faces.empty()) continue; // without Qhull
        ++known;
        const Quat turned = draw.random.rotation();
        const V3 at = load(Vec3(length * draw.random.in_cube(2)));
        const Core placed_hull = placed(local, rotation(turned), at);
        const Vec3 mean = 0.25 * (points[0] + points[1] + points[2] + points[3]);
        const Vec3 p = mean + draw.random.between(0, 1) * (points.back() - mean) +
                       (draw.random.chance(0.3) ? 0.3 : 0.0) * draw.random.in_cube(1).cwiseProduct(size);
        const double found = depth(placed_hull, at + rotation(turned) * load(p)) / length;
        const Real truth = depth_in_hull(corners, (1 / Real{length}) * real(load(p)));
        CHECK(found <= truth + 4e-15L);
        if (truth > 1e-6L) CHECK(found >= truth - 1e-10L);
        if (truth < 0) CHECK(!(found > 4e-15));
        inside += truth > 1e-6L;
        outside += truth < 0;
    }
    CHECK((known == 0 || inside > 500));
    CHECK((known == 0 || outside > 100));
}

TEST_CASE("depth: no direction leads out sooner, and none does outside")
{
    SolidCores draw(91);
    int inside[4] = {}, outside = 0;
    for (int i = 0; i < 12'000; ++i) {
        const int kind = i % 4;
        const Sample s = solid_shape(draw, kind);
        const Quat turned = draw.random.rotation();
        const V3 at = load(draw.random.in_cube(3)), u = load(draw.random.in_cube(1.1));
        const V3 p = at + rotation(turned) * V3{u.x * s.size.x, u.y * s.size.y, u.z * s.size.z};
        const double found = depth(placed(s.local, rotation(turned), at), p);
        const Real truth = way_out(draw.random, s.shape, turned, at, p);
        CAPTURE(i);
        if (truth < 0) CHECK(!(found > 1e-14));
        outside += truth < 0;
        if (!(found > 1e-14)) continue;
        CHECK(found <= truth + 1e-14);
        if (kind < 3) CHECK(found >= truth - 1e-14);
        ++inside[kind];
    }
    for (const int count : inside)
        CHECK(count > 400);
    CHECK(outside > 3'000);
}

TEST_CASE("depth: by hand, from the centre outwards")
{
    const Core box = core(Box{{1, 2, 3}}), cylinder = core(Cylinder{2, 1.5});
    CHECK(depth(box, {}) == 1);
    CHECK(depth(box, {0, -1.75, 0}) == 0.25);
    CHECK(depth(box, {0, 0, 3}) == 0);
    CHECK(depth(box, {0, 0, -3.5}) == -0.5);
    CHECK(depth(cylinder, {0, -1, 0}) == 0.5);
    CHECK(depth(cylinder, {0, 0, 1.75}) == 0.25);
    CHECK(depth(cylinder, {3, 4, 0}) == -3.5);

    // 3 high, 1.25 wide at the base: the side falls by 12 over 5, and the sine at the apex is 5 / 13.
    const Core cone = core(Cone{1.5, 1.25});
    CHECK(depth(cone, {0, 0, -1.25}) == 0.25);
    CHECK(depth(cone, {0, 0, 1.5 - 1.3}) == doctest::Approx(0.5));
    CHECK(depth(cone, {0.625, 0, 0}) == doctest::Approx(0));
    CHECK(depth(cone, {0, 0, 2}) < 0);

    CHECK(depth(core(Ellipsoid{{1, 2, 3}}), {}) == 1);
    CHECK(depth(core(Ellipsoid{{2, 2, 2}}), {0, 1.5, 0}) == doctest::Approx(0.5));
    CHECK(depth(core(Ellipsoid{{1, 2, 3}}), {0, 2.5, 0}) < 0);
}

TEST_CASE("depth: none of what has no inside")
{
    SolidCores draw(92);
    CHECK(depth(core(Sphere{1}), {}) == -infinity); // its core is a point
    for (const int kind : {6, 7})
        CHECK(depth(draw.local(kind), {}) == -infinity);
    const Vec3 square[] = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}};
    CHECK(!(depth(core(Hull::from_points(square)), {}) > 0));
}

TEST_CASE("depth: a cone that is a disc, a line or a point holds no point deep, and none outside of it")
{
    const Core disc = core(Cone{0, 2}), line = core(Cone{1, 0}), apex = core(Cone{0, 0});
    CHECK(depth(disc, {1, 1, 0}) == 0);
    CHECK(depth(disc, {2, 1, 0}) < 0);
    CHECK(depth(line, {0, 0, 0.5}) == 0);
    CHECK(depth(line, {0, 0, 1.5}) < 0);
    CHECK(depth(line, {0.25, 0, 0}) < 0);
    CHECK(depth(apex, {}) == 0);
    for (const double side : {-1e-12, 1e-12}) {
        CHECK(depth(disc, {0, 0, side}) < 0);
        CHECK(depth(apex, {0, 0, side}) < 0);
        CHECK(depth(apex, {side, 0, 0}) < 0);
    }
}
