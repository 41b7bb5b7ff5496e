// SPDX-License-Identifier: BSD-3-Clause
#include "sweep.h"

#include "support/draw.h"
#include "support/exact_mover.h"
#include "support/moving.h"
#include "support/query.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace brink;
using support::Random;
using support::Real;
using support::Real3;
using support::real3;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr double tight = 1e-6; // a float and what it is rounded outwards by

bool is_everywhere(const Sweep& s)
{
    bool all = s.radius == inf;
    for (int axis = 0; axis < 3; ++axis)
        all = all && s.box.min[axis] == -inf && s.box.max[axis] == inf;
    return all;
}

Real coordinate(const Real3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

bool contains(const Box3f& box, const Real3& p)
{
    bool in = true;
    for (int axis = 0; axis < 3; ++axis) {
        const Real x = coordinate(p, axis);
        in = in && Real{box.min[axis]} <= x && x <= Real{box.max[axis]};
    }
    return in;
}

bool ball_contains(const Sweep& s, const Real3& p, Real t)
{
    const Real3 from{s.from[0], s.from[1], s.from[2]}, by{s.by[0], s.by[1], s.by[2]};
    return norm(p - (from + t * by)) <= Real{s.radius};
}

/// How many of the sampled points are outside of the box or the ball.
int outside(const Body& body, V3 origin, Random& random)
{
    const Sweep s = sweep(body, origin);
    const support::ExactMover moving(body.shape, body.motion, {origin.x, origin.y, origin.z});
    int out = 0;
    for (int k = 0; k <= 8; ++k) {
        const double inner = random.between(0, 1);
        const Real t = k == 0 ? 0 : k == 8 ? 1 : Real{inner};
        for (int d = 0; d < 8; ++d) {
            const Real3 any = real3(random.unit());
            const Real sign = d % 2 == 0 ? 1 : -1;
            const Real3 along[4] = {{sign, 0, 0}, {0, sign, 0}, {0, 0, sign}, any};
            const Real3 p = moving.support(along[d / 2], t);
            out += contains(s.box, p) ? 0 : 1;
            out += ball_contains(s, p, t) ? 0 : 1;
        }
    }
    return out;
}

std::size_t bounded_kind(Random& random)
{
    const auto kind = static_cast<std::size_t>(random.index(8));
    return kind < 4 ? kind : kind + 2; // all but plane and half-space
}

Body scaled_body(Random& random, double size, double far)
{
    Body body;
    body.shape = support::draw_shape(random, bounded_kind(random), support::ShapeStyle::any);
    Motion& m = body.motion;
    const double length = random.log_between(1e-3, 1e3);
    m.start.position = far * random.in_cube(1);
    m.start.orientation = support::draw_orientation(random);
    m.translation = random.chance(0.3) ? Vec3{0, 0, 0} : Vec3{size * length * random.in_cube(1)};
    const Vec3 axis = random.unit();
    const double turn = random.index(4) == 0 ? random.log_between(1e-6, 1e6) : random.between(0, 7);
    if (random.chance(0.7)) m.rotation = turn * axis;
    if (random.chance(0.6)) m.pivot = size * random.in_cube(3);
    return body;
}

/// Sizes times a power of two, which is exact.
void scale(Shape& shape, double by)
{
    const auto times = [by](auto& s) {
        using T = std::decay_t<decltype(s)>;
        if constexpr (std::is_same_v<T, Sphere>) s.radius *= by;
        if constexpr (std::is_same_v<T, Capsule>) s.a *= by, s.b *= by, s.radius *= by;
        if constexpr (std::is_same_v<T, Box>) s.half_extents *= by;
        if constexpr (std::is_same_v<T, Triangle>) s.a *= by, s.b *= by, s.c *= by;
        if constexpr (std::is_same_v<T, Cylinder> || std::is_same_v<T, Cone>)
            s.half_length *= by, s.radius *= by;
        if constexpr (std::is_same_v<T, Ellipsoid>) s.radii *= by;
        if constexpr (std::is_same_v<T, Hull>) {
            std::vector<Vec3> points(s.vertices().begin(), s.vertices().end());
            for (Vec3& p : points)
                p *= by;
            if (!points.empty()) s = Hull::from_points(points);
        }
    };
    std::visit(times, shape);
}

} // namespace

TEST_CASE("sweep: box and ball hold the exact moving body at every time")
{
    int turning = 0, off_pivot = 0, kinds[std::variant_size_v<Shape>] = {};
    for (int i = 0; i < 8'000; ++i) {
        Random random(20261122, static_cast<std::uint64_t>(i));
        const bool far = random.chance(0.3), seen_from_there = random.chance(0.5);
        const Body body = scaled_body(random, 1, far ? 1e8 : 10);
        const Vec3 near = body.motion.start.position + random.in_cube(100);
        CAPTURE(i);
        CHECK(outside(body, seen_from_there ? load(near) : V3{}, random) == 0);
        turning += body.motion.rotation.norm() > 1;
        off_pivot += body.motion.pivot.norm() > 0;
        ++kinds[body.shape.index()];
    }
    CHECK(turning > 3'000);
    CHECK(off_pivot > 3'000);
    for (std::size_t k = 0; k < std::size(kinds); ++k)
        CHECK(kinds[k] > (k == 4 || k == 5 ? -1 : 500));
}

TEST_CASE("sweep: of every size, from below the smallest float to all of space")
{
    int everywhere = 0, culled = 0;
    for (int i = 0; i < 4'000; ++i) {
        Random random(7, static_cast<std::uint64_t>(i));
        const int exponent[] = {-1000, -160, -140, -100, 50, 100, 126, 500, 990};
        const double size = std::ldexp(1, exponent[i % 9]);
        const double spread = random.between(0, 10);
        Body body = scaled_body(random, size, size * spread);
        scale(body.shape, size);
        const Sweep s = sweep(body, {});
        CAPTURE(i);
        if (is_everywhere(s)) {
            ++everywhere;
            CHECK(exponent[i % 9] >= 100);
        } else {
            ++culled;
            CHECK(exponent[i % 9] <= 126);
            CHECK(outside(body, {}, random) == 0);
        }
    }
    CHECK(everywhere > 1'000);
    CHECK(culled > 2'000);
    CHECK(is_everywhere(sweep({Sphere{1e300}, {}}, {})));
    CHECK(is_everywhere(sweep({Box{{1, 1, 1}}, support::resting({0, 1e300, 0})}, {})));
    CHECK(is_everywhere(sweep({Sphere{0}, support::moving({0, 0, 0}, {-1e300, 1e300, 0})}, {})));
}

TEST_CASE("sweep: tight about what stands still and what only travels")
{
    Random random(3);
    for (int i = 0; i < 4'000; ++i) {
        const double size = random.log_between(1e-3, 1e3);
        const Vec3 at = random.in_cube(10), by = random.in_cube(30);
        const std::size_t kind = bounded_kind(random);
        const Quat turn = random.rotation();
        Body body{support::draw_shape(random, kind, support::ShapeStyle::any), support::moving(at, by)};
        scale(body.shape, size);
        body.motion.start.orientation = turn;
        if (i % 2 == 0) body.motion.translation = Vec3(0, 0, 0);
        const Sweep s = sweep(body, {});
        const Aabb start = bounds(body.shape, body.motion.start), end = bounds(body.shape, body.motion.at(1));
        CAPTURE(i);
        for (int axis = 0; axis < 3; ++axis) {
            const double low = std::min(start.min[axis], end.min[axis]),
                         high = std::max(start.max[axis], end.max[axis]);
            CHECK(static_cast<double>(s.box.min[axis]) <= low);
            CHECK(static_cast<double>(s.box.max[axis]) >= high);
            CHECK(low - static_cast<double>(s.box.min[axis]) <= tight * std::fabs(low) + 1e-11);
            CHECK(static_cast<double>(s.box.max[axis]) - high <= tight * std::fabs(high) + 1e-11);
        }
    }
    // Seen from near by, an offset costs no more than its own rounding.
    const Sweep far = sweep({Sphere{1}, support::resting({1e8, 0, 0})}, {1e8, 0, 0});
    CHECK(far.box.max[0] <= 1 + 1e-6F);
    // A whole turn about a far pivot is as wide as its circle and no wider.
    Motion swing{.translation = Vec3(0, 0, 0), .rotation = Vec3(0, 0, 6), .pivot = Vec3(10, 0, 0)};
    const Sweep circle = sweep({Sphere{1}, swing}, {});
    CHECK(circle.box.max[0] == doctest::Approx(21));
    CHECK(circle.box.min[1] == doctest::Approx(-11));
    CHECK(circle.radius == doctest::Approx(11));
}

TEST_CASE("sweep: leaves room for the band in which bodies may be called in contact")
{
    // Twice 16 eps of all lengths. Both positions are floats, and what lies at zero rounds by nothing there.
    constexpr double eps = std::numeric_limits<double>::epsilon();
    const double far = 1e8, least = 32 * eps * far;
    const Sweep ball = sweep({Sphere{0x1p-10}, support::resting({far, 0, 0})}, {});
    CHECK(static_cast<double>(ball.box.max[1]) >= 0x1p-10 + least);
    CHECK(static_cast<double>(ball.box.min[2]) <= -0x1p-10 - least);
    CHECK(static_cast<double>(ball.radius) >= 0x1p-10 + least);
    const Sweep back = sweep({Capsule{{0, 0, 0}, {0, -far, 0}, 0}, support::resting({0, far, 0})}, {});
    CHECK(static_cast<double>(back.box.min[1]) <= -least);
    Motion swing = support::moving({far, 0, 0}, {0, 0, 0});
    swing.rotation = Vec3(0, 7, 0);
    const Sweep turning = sweep({Capsule{{0, 0, 0}, {0, 0, 0.25}, 0}, swing}, {});
    CHECK(static_cast<double>(turning.box.max[1]) >= 0.25 + least);
    CHECK(static_cast<double>(turning.radius) >= 0.25 + least);
}

TEST_CASE("sweep: a sphere on its pivot need not have an orientation, and half way is where it says")
{
    Motion m = support::moving({1, 2, 3}, {4, 0, 0});
    m.start.orientation.coeffs().setConstant(std::numeric_limits<double>::quiet_NaN());
    CHECK(sweep({Sphere{1}, m}, {}).box.max[0] == doctest::Approx(6));
    CHECK(midway({Sphere{1}, m}) == V3{3, 2, 3});
    CHECK(farthest_from_origin(Capsule{{3, 0, 0}, {0, 4, 0}, 1}) == 5);
    CHECK(farthest_from_origin(Plane{}) == 0);
    const Box3f there = standing(Box{{1, 2, 3}}, {{10, 0, 0}, Quat(1, 0, 0, 0)}, {5, 0, 0});
    CHECK(there.max[0] == doctest::Approx(6));
    CHECK(there.min[2] == doctest::Approx(-3));
}

TEST_CASE("round_up, round_down: outwards, and by little")
{
    Random random(11);
    int denormal = 0, beyond = 0;
    for (int i = 0; i < 200'000; ++i) {
        const int exponent = i % 2 == 0 ? random.index(300) - 160 : random.index(2080) - 1060;
        const double mantissa = random.between(-2, 2), x = std::ldexp(mantissa, exponent);
        const float up = round_up(x), down = round_down(x);
        CAPTURE(x);
        CHECK(static_cast<double>(down) < x);
        CHECK(x < static_cast<double>(up));
        denormal += x != 0 && std::fabs(x) < 0x1p-126;
        beyond += std::fabs(x) > 0x1p128;
        if (std::fabs(x) > 0x1p127) continue;
        CHECK(static_cast<double>(up) - x <= tight * std::fabs(x) + 0x1p-147);
        CHECK(x - static_cast<double>(down) <= tight * std::fabs(x) + 0x1p-147);
    }
    CHECK(denormal > 20'000);
    CHECK(beyond > 20'000);
    CHECK(round_up(infinity) == inf);
    CHECK(round_down(-infinity) == -inf);
    CHECK(static_cast<double>(round_up(-infinity)) > -infinity);
    CHECK(round_up(0) > 0);
    for (const double edge : {double{std::numeric_limits<float>::max()}, 0x1.fffffefp127, 0x1p128, 1e308})
        CHECK(static_cast<double>(round_up(edge)) > edge);
}
