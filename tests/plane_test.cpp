// SPDX-License-Identifier: BSD-3-Clause
#include "random.h"
#include "vector.h"

#include <brink/plane.h>
#include <doctest/doctest.h>

using namespace brink;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

bool is_none(const Plane& p) { return p.normal == Vec3(0, 0, 0) && p.offset == 0; }

} // namespace

TEST_CASE("plane: through three points, seen from where they turn to the left")
{
    const Plane p = Plane::through({1, 0, 5}, {2, 0, 5}, {1, 1, 5});
    CHECK(p.normal == Vec3(0, 0, 1));
    CHECK(p.offset == 5);
    CHECK(Plane::through({1, 1, 5}, {2, 0, 5}, {1, 0, 5}).normal == Vec3(0, 0, -1));
}

TEST_CASE("plane: passes through its points, slivers and far ones too")
{
    support::Random random(20261122);
    int slivers = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double thin = random.log_between(1e-9, 1), far = random.log_between(1, 1e6),
                     along = random.between(-1, 2);
        const Vec3 at = far * random.in_cube(1), e = random.unit(), f = random.unit();
        const Vec3 a = at, b = at + e, c = at + along * e + thin * f;
        const Plane p = Plane::through(a, b, c);
        CAPTURE(i);
        if (is_none(p)) continue; // its sides are parallel up to rounding
        CHECK(std::fabs(norm(load(p.normal)) - 1) <= 4 * eps);
        for (const Vec3& x : {a, b, c})
            CHECK(std::fabs(dot(load(p.normal), load(x)) - p.offset) <= 16 * eps * (far + 2));
        const V3 side = cross(load(Vec3(b - a)), load(Vec3(c - a)));
        if (thin > 1e-3) CHECK(dot(side, load(p.normal)) > 0);
        slivers += thin < 1e-6;
    }
    CHECK(slivers > 4'000);
}

TEST_CASE("plane: any scale")
{
    for (const double scale : {1e-300, 1e-160, 1.0, 1e160, 1.7e308}) {
        const Plane p = Plane::through({-scale, 0, scale / 2}, {scale, 0, scale / 2}, {0, scale, scale / 2});
        CHECK((p.normal - Vec3(0, 0, 1)).norm() <= 2 * eps);
        CHECK(std::fabs(p.offset / scale - 0.5) <= 4 * eps);
    }
    CHECK(Plane::through({0, 0, 0}, {1e-200, 0, 0}, {0, 1, 0}).normal == Vec3(0, 0, 1)); // legs of any ratio
}

TEST_CASE("plane: none through collinear, equal or infinite points")
{
    CHECK(is_none(Plane::through({0, 0, 0}, {1, 1, 1}, {3, 3, 3})));
    CHECK(is_none(Plane::through({0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}, {1, 2, 3})));
    CHECK(is_none(Plane::through({1, 2, 3}, {1, 2, 3}, {1, 2, 3})));
    CHECK(is_none(Plane::through({0, 0, 0}, {infinity, 0, 0}, {0, 1, 0})));
    CHECK(is_none(Plane::through({0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0})));
}
