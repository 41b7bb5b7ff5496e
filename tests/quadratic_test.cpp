// SPDX-License-Identifier: BSD-3-Clause
#include "quadratic.h"

#include <doctest/doctest.h>

using namespace brink;

namespace {

double first_root(double b, double c, double discriminant)
{
    return brink::first_root(both(b), both(c), both(discriminant))[0];
}

} // namespace

TEST_CASE("first_root: t^2 - 5 t + 4 falls to zero at 1")
{
    CHECK(first_root(-2.5, 4, 2.25) == 1);
    CHECK(first_root(-2.5, 0, 6.25) == 0);       // starts there
    CHECK(first_root(-2.5, -1, 7.25) == 0);      // starts below
    CHECK(first_root(2.5, 4, 2.25) == infinity); // rises
    CHECK(first_root(-1, 4, -3) == infinity);    // never gets there
    CHECK(first_root(-2, 4, 0) == 2);            // touches
}

TEST_CASE("ray_ball: head-on, tangent, away, past, inside, at rest")
{
    CHECK(ray_ball({5, 0, 0}, {-8, 0, 0}, 1) == 0.5);
    CHECK(ray_ball({3, 1, 0}, {-3, 0, 0}, 1) == 1); // tangency is contact
    CHECK(ray_ball({3, 1 + 0x1p-40, 0}, {-3, 0, 0}, 1) == infinity);
    CHECK(ray_ball({5, 0, 0}, {8, 0, 0}, 1) == infinity);
    CHECK(ray_ball({5, 2, 0}, {-8, 0, 0}, 1) == infinity);
    CHECK(ray_ball({0.5, 0, 0}, {-8, 0, 0}, 1) == 0);
    CHECK(ray_ball({1, 0, 0}, {8, 0, 0}, 1) == 0); // on the surface is contact
    CHECK(ray_ball({5, 0, 0}, {0, 0, 0}, 1) == infinity);
    CHECK(ray_ball({4, 0, 0}, {-8, 0, 0}, 0) == 0.5); // a point through a point
}

TEST_CASE("ray_ball: a start 1e7 radii away does not lose the ball")
{
    // b^2 - a c loses (|from| / radius)^2 eps = 2e-2 of the discriminant here; the cross product does not.
    CHECK(ray_ball({1e7, 0.999, 0}, {-2e7, 0, 0}, 1) == doctest::Approx(0.5).epsilon(1e-7));
    CHECK(ray_ball({1e7, 1.001, 0}, {-2e7, 0, 0}, 1) == infinity);
}
