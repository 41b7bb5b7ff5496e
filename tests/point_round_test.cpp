// SPDX-License-Identifier: BSD-3-Clause
#include "point_round.h"
#include "polytope.h"
#include "solid_cores.h"

#include <doctest/doctest.h>

using namespace brink;
using support::Random;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

FromPoint of(const Cylinder& c, V3 p) { return from_point(p, core(c)); }
FromPoint of(const Cone& c, V3 p) { return from_point(p, core(c)); }

} // namespace

TEST_CASE("point and cylinder: side, end, rim, inside")
{
    CHECK(of(Cylinder{1, 2}, {5, 0, 0}).gap == 3);
    CHECK(of(Cylinder{1, 2}, {5, 0, 0}).normal == V3{-1, 0, 0});
    CHECK(of(Cylinder{1, 2}, {0, 1, 4}).gap == 3);
    CHECK(of(Cylinder{1, 2}, {0, 5, 5}).gap == 5);
    CHECK(of(Cylinder{1, 2}, {0, 1.75, 0.5}).gap == -0.25);
    CHECK(of(Cylinder{1, 2}, {0, 1, -0.75}).gap == -0.25);
    CHECK(of(Cylinder{1, 2}, {0, 1, -0.75}).normal == V3{0, 0, 1});
    CHECK(of(Cylinder{0, 0}, {0, 3, 4}).gap == 5);
}

TEST_CASE("point and cone: side, base, apex, rim, inside")
{
    CHECK(of(Cone{1, 2}, {0, 0, 3}).gap == 2);
    CHECK(of(Cone{1, 2}, {0, 1, -4}).gap == 3);
    CHECK(of(Cone{1, 2}, {5, 0, -5}).gap == 5);
    CHECK(std::fabs(of(Cone{1, 2}, {1, 0, 1}).gap - std::sqrt(0.5)) <= eps);
    CHECK(of(Cone{1, 2}, {0, 0, -0.75}).gap == -0.25);
    CHECK(std::fabs(of(Cone{1, 2}, {0, 0, 0.75}).gap + std::sqrt(0.03125)) <= eps);
    CHECK(of(Cone{0, 2}, {1, 0, 0}).gap == 0); // a disc
    CHECK(of(Cone{0, 2}, {5, 0, 4}).gap == 5);
    CHECK(of(Cone{2, 0}, {1, 0, 1}).gap == 1); // a segment
    CHECK(of(Cone{2, 0}, {0, 0, 5}).gap == 3);
    CHECK(of(Cone{0, 0}, {0, 0, 5}).gap == 5); // a point
}

TEST_CASE("point against cylinder and cone: as for any cores")
{
    SolidCores cores(121);
    Random& random = cores.random;
    int inside = 0;
    for (int i = 0; i < 10'000; ++i) {
        const Core c = placed(cores.local(i % 2), rotation(random.rotation()), load(random.in_cube(1)));
        const double reach = random.chance(0.5) ? 0.5 : 3;
        const Core p = placed(core(Sphere{}), {}, reach * load(random.in_cube(1)));
        const Separation s = separation(p, c), other = polytope_separation(p, c);
        const double size = std::max(extent(p), extent(c));
        CAPTURE(i);
        CHECK(std::fabs(s.gap - other.gap) <= 1e-9 * size);
        CHECK(std::fabs(s.lower - gap_along(p, c, s.normal)) <= 8 * eps * size);
        CHECK(s.gap - s.lower <= 16 * eps * size);
        CHECK(std::fabs(norm(s.normal) - 1) <= 4 * eps);
        inside += s.gap < 0;
    }
    CHECK(inside > 500);
}
