// SPDX-License-Identifier: BSD-3-Clause
#include "random.h"
#include "vector.h"

#include <brink/shape.h>
#include <doctest/doctest.h>

using namespace brink;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double eps = std::numeric_limits<double>::epsilon();
const double half = std::sqrt(0.5);

using Real = long double;
struct R3 {
    Real x, y, z;
};

/// position + M(q) / |q|^2 * v in long double.
R3 world(const Pose& pose, const Vec3& v)
{
    const double* c = pose.orientation.coeffs().data();
    const Real x = c[0], y = c[1], z = c[2], w = c[3], s = 2 / (x * x + y * y + z * z + w * w);
    const Real a = v.x(), b = v.y(), d = v.z();
    return {
        pose.position.x() + (1 - s * (y * y + z * z)) * a + s * (x * y - w * z) * b + s * (x * z + w * y) * d,
        pose.position.y() + s * (x * y + w * z) * a + (1 - s * (x * x + z * z)) * b + s * (y * z - w * x) * d,
        pose.position.z() + s * (x * z - w * y) * a + s * (y * z + w * x) * b +
            (1 - s * (x * x + y * y)) * d};
}

bool contains(const Aabb& box, R3 p, Real radius)
{
    return box.min.x() <= p.x - radius && box.min.y() <= p.y - radius && box.min.z() <= p.z - radius &&
           box.max.x() >= p.x + radius && box.max.y() >= p.y + radius && box.max.z() >= p.z + radius;
}

bool equal(const Aabb& box, const Vec3& min, const Vec3& max) { return box.min == min && box.max == max; }

/// How far the box reaches past the corners grown by the radius, at most.
Real excess(const Aabb& box, const R3* corners, int count, Real radius)
{
    R3 low = corners[0], high = corners[0];
    for (int k = 1; k < count; ++k) {
        low = {std::min(low.x, corners[k].x), std::min(low.y, corners[k].y), std::min(low.z, corners[k].z)};
        high = {std::max(high.x, corners[k].x), std::max(high.y, corners[k].y),
                std::max(high.z, corners[k].z)};
    }
    return std::max({low.x - radius - box.min.x(), low.y - radius - box.min.y(), low.z - radius - box.min.z(),
                     box.max.x() - high.x - radius, box.max.y() - high.y - radius,
                     box.max.z() - high.z - radius});
}

} // namespace

TEST_CASE("bounds: exact where nothing is rounded")
{
    const Pose at{{1, 2, 3}, Quat(1, 0, 0, 0)};
    CHECK(equal(bounds(Sphere{1}, at), {0, 1, 2}, {2, 3, 4}));
    CHECK(equal(bounds(Capsule{{0, 0, -1}, {0, 0, 1}, 0.5}, at), {0.5, 1.5, 1.5}, {1.5, 2.5, 4.5}));
    CHECK(equal(bounds(Box{{1, 2, 3}}, at), {0, 0, 0}, {2, 4, 6}));
    CHECK(equal(bounds(Triangle{{0, 0, 0}, {1, 0, -1}, {0, 4, 0}}, at), {1, 2, 2}, {2, 6, 3}));
    // A quarter turn about z, and a third of a turn about the diagonal: axes onto axes.
    CHECK(equal(bounds(Box{{1, 2, 3}}, {{0, 0, 0}, Quat(half, 0, 0, half)}), {-2, -1, -3}, {2, 1, 3}));
    CHECK(equal(bounds(Box{{1, 2, 3}}, {{0, 0, 0}, Quat(0.5, 0.5, 0.5, 0.5)}), {-3, -1, -2}, {3, 1, 2}));
}

TEST_CASE("bounds: a sum that rounds is rounded outwards by one ulp")
{
    const Aabb box = bounds(Sphere{0.1}, {{1, 1, 1}, Quat(1, 0, 0, 0)});
    CHECK(static_cast<Real>(box.min.x()) <= static_cast<Real>(1) - 0.1);
    CHECK(static_cast<Real>(box.max.x()) >= static_cast<Real>(1) + 0.1);
    CHECK(box.max.x() - box.min.x() <= 0.2 + 4 * eps);
    const Aabb tiny = bounds(Sphere{5e-324}, {{1, -1, 0}, Quat(1, 0, 0, 0)});
    CHECK(tiny.min.x() == 1 - eps / 2);
    CHECK(tiny.max.x() == 1 + eps);
    CHECK(tiny.max.y() == -1 + eps / 2);
    CHECK(tiny.max.z() == 5e-324);
}

TEST_CASE("bounds: contains every corner grown by the radius, and little more")
{
    support::Random random(20261122);
    int tight = 0;
    for (int i = 0; i < 60'000; ++i) {
        const double size = random.log_between(1e-6, 1e3), far = random.log_between(1e-3, 1e6),
                     stretch = random.between(1 - 4e-7, 1 + 4e-7);
        const Vec3 p = size * random.in_cube(1), q = random.in_cube(1), s = random.in_cube(size),
                   at = far * random.in_cube(1);
        const double r = random.index(3) * random.between(0, size);
        Quat turn = random.rotation();
        turn.coeffs() *= stretch;
        const Pose pose{at, turn};
        const Vec3 h = p.cwiseAbs();
        R3 corners[8];
        int count = i % 3 == 0 ? 2 : 3;
        for (int k = 0; k < 3; ++k)
            corners[k] = world(pose, k == 0 ? p : k == 1 ? q : s);
        Shape shape = Capsule{p, q, r};
        if (i % 3 == 1) shape = Triangle{p, q, s};
        if (i % 3 == 2) {
            shape = Box{h};
            count = 8;
            for (int k = 0; k < 8; ++k)
                corners[k] =
                    world(pose, {k & 1 ? h.x() : -h.x(), k & 2 ? h.y() : -h.y(), k & 4 ? h.z() : -h.z()});
        }
        const double radius = i % 3 == 0 ? r : 0;
        const Aabb box = bounds(shape, pose);
        CAPTURE(i);
        for (int k = 0; k < count; ++k)
            CHECK(contains(box, corners[k], radius));
        const double scale = far + std::max({size, 1.0}) * 3;
        const double over = static_cast<double>(excess(box, corners, count, radius));
        CHECK(over <= 32 * eps * scale);
        tight += over <= 8 * eps * scale;
    }
    CHECK(tight > 10'000);
}

TEST_CASE("bounds: planes and half-spaces")
{
    const Vec3 all(infinity, infinity, infinity);
    const Pose at{{0, 0, 10}, Quat(1, 0, 0, 0)};
    CHECK(equal(bounds(Plane{{0, 0, 1}, 2}, at), {-infinity, -infinity, 12}, {infinity, infinity, 12}));
    CHECK(equal(bounds(Plane{{0, 0, -1}, 2}, at), {-infinity, -infinity, 8}, {infinity, infinity, 8}));
    CHECK(equal(bounds(HalfSpace{{0, 0, 1}, 2}, at), -all, {infinity, infinity, 12}));
    CHECK(equal(bounds(HalfSpace{{0, 0, -1}, 2}, at), {-infinity, -infinity, 8}, all));
    // Turned upside down about x: solid above now.
    CHECK(equal(bounds(HalfSpace{{0, 0, 1}, 2}, {{0, 0, 10}, Quat(0, 1, 0, 0)}), {-infinity, -infinity, 8},
                all));
    // A quarter turn about y takes z to x.
    CHECK(equal(bounds(HalfSpace{{0, 0, 1}, 2}, {{1, 0, 0}, Quat(half, 0, half, 0)}), -all,
                {3, infinity, infinity}));
    // Not quite along an axis is unbounded, however little.
    CHECK(equal(bounds(HalfSpace{{1e-300, 0, 1}, 2}, at), -all, all));
    CHECK(equal(bounds(Plane{{0, 0, 1}, 2}, {{0, 0, 0}, Quat(1, 1e-200, 0, 0)}), -all, all));
    // Distances are divided by the normal's length.
    const double longer = 1 + 4e-7;
    const Aabb scaled = bounds(Plane{{0, 0, longer}, 2}, Pose{});
    CHECK(static_cast<Real>(scaled.min.z()) * longer < 2);
    CHECK(static_cast<Real>(scaled.max.z()) * longer > 2);
    CHECK(scaled.max.z() - scaled.min.z() <= 4 * eps);
}

TEST_CASE("bounds: the largest numbers, and bad input")
{
    const Vec3 all(infinity, infinity, infinity);
    const Aabb huge = bounds(Sphere{1e308}, {{1.5e308, 0, -1.5e308}, Quat(1, 0, 0, 0)});
    CHECK(huge.max.x() == infinity);
    CHECK(huge.min.z() == -infinity);
    CHECK(huge.min.x() == 5e307);
    CHECK(equal(bounds(Sphere{-1}, Pose{}), -all, all));
    CHECK(equal(bounds(Box{{1, not_a_number, 1}}, Pose{}), -all, all));
    CHECK(equal(bounds(Sphere{1}, {{0, 0, 0}, Quat(not_a_number, not_a_number, not_a_number, not_a_number)}),
                {-1, -1, -1}, {1, 1, 1}));
}
