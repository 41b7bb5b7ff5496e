// SPDX-License-Identifier: BSD-3-Clause
#include "random.h"

#include <brink/distance.h>
#include <brink/overlap.h>
#include <doctest/doctest.h>

using namespace brink;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double eps = std::numeric_limits<double>::epsilon();

Pose at(double x, double y, double z) { return {{x, y, z}, Quat(1, 0, 0, 0)}; }

} // namespace

TEST_CASE("overlap: tangent balls overlap, an ulp apart they do not")
{
    CHECK(overlaps(Sphere{1}, Pose{}, Sphere{2}, at(3, 0, 0)));
    CHECK(overlaps(Sphere{1}, at(1e6, 0, 0), Sphere{2}, at(1e6 - 3, 0, 0)));
    CHECK(!overlaps(Sphere{1}, Pose{}, Sphere{2}, at(3 + 2 * eps, 0, 0)));
    CHECK(overlaps(Sphere{1}, Pose{}, Sphere{2 + 2 * eps}, at(3 + 2 * eps, 0, 0)));
    CHECK(overlaps(Sphere{0}, at(5, 6, 7), Sphere{0}, at(5, 6, 7)));
    CHECK(overlaps(Sphere{1}, Pose{}, Sphere{4}, at(3, 0, 4)));
}

TEST_CASE("overlap: the exact answer for balls with integer coordinates, at any scale")
{
    support::Random random(20261122);
    int tangent = 0, apart = 0, overlapping = 0;
    for (int i = 0; i < 200'000; ++i) {
        const int triples[][4] = {{2, 3, 6, 7}, {1, 4, 8, 9}, {4, 4, 7, 9}, {0, 3, 4, 5}, {6, 10, 15, 19}};
        const int* triple = triples[random.index(5)]; // three legs and their diagonal
        const bool aimed = random.chance(0.5);
        const int any_x = random.index(20), any_y = random.index(20), any_z = random.index(20),
                  radii = random.index(30);
        const int x = aimed ? triple[0] : any_x, y = aimed ? triple[1] : any_y, z = aimed ? triple[2] : any_z;
        const int s = random.index(radii + 1), r = radii - s, square = x * x + y * y + z * z;
        const double unit = std::ldexp(1.0, random.index(900) - 450);
        const bool answer =
            overlaps(Sphere{r * unit}, Pose{}, Sphere{s * unit}, at(x * unit, y * unit, z * unit));
        CAPTURE(i);
        CHECK(answer == (square <= radii * radii));
        tangent += square == radii * radii;
        apart += square > radii * radii;
        overlapping += square < radii * radii;
    }
    CHECK(tangent > 500);
    CHECK(apart > 20'000);
    CHECK(overlapping > 20'000);
}

TEST_CASE("overlap: what rounding the sums would get wrong")
{
    // The radii sum to 1 + 2^-60, which rounds to 1; the distance to 1 + 2^-61 and 1 + 2^-59, which do too.
    const Shape big = Sphere{1}, little = Sphere{0x1p-60};
    CHECK(overlaps(big, at(0x1p-61, 0, 0), little, at(-1, 0, 0)));
    CHECK(!overlaps(big, at(0x1p-59, 0, 0), little, at(-1, 0, 0)));
    // 1 + 2^-120 against 1: the second coordinate decides.
    CHECK(!overlaps(Sphere{1}, Pose{}, Sphere{0}, at(1, 0x1p-60, 0)));
    CHECK(overlaps(Sphere{1}, Pose{}, Sphere{0x1p-100}, at(1, 0x1p-60, 0)));
}

TEST_CASE("overlap: the ends of the exponent range")
{
    CHECK(overlaps(Sphere{1e308}, at(1e308, 0, 0), Sphere{1.7e308}, at(-1.6e308, 0, 0)));
    CHECK(!overlaps(Sphere{1e307}, at(1.6e308, 0, 0), Sphere{1e307}, at(-1.6e308, 0, 0)));
    CHECK(overlaps(Sphere{3e-300}, Pose{}, Sphere{2e-300}, at(0, 4e-300, 3e-300)));
    CHECK(!overlaps(Sphere{3e-300}, Pose{}, Sphere{1e-300}, at(0, 4e-300, 3e-300)));
    CHECK(!overlaps(Sphere{}, Pose{}, Sphere{}, at(0, 5e-324, 0)));
}

TEST_CASE("overlap: the other shapes, touching included")
{
    const Shape box = Box{{1, 1, 1}}, wall = HalfSpace{{1, 0, 0}, -1}, floor = Plane{{0, 0, 1}, 0};
    CHECK(overlaps(box, at(2, 2, 2), box, Pose{})); // corner on corner
    CHECK(!overlaps(box, at(2 + 4 * eps, 0, 0), box, Pose{}));
    CHECK(overlaps(box, Pose{}, wall, Pose{}));
    CHECK(!overlaps(box, at(0.5, 0, 0), wall, Pose{}));
    CHECK(overlaps(floor, Pose{}, box, at(0, 0, -1)));
    CHECK(!overlaps(floor, Pose{}, box, at(0, 0, -1.25)));
    CHECK(overlaps(Sphere{5}, at(4, 5, 0), box, Pose{})); // 3, 4, 5 from the edge
    CHECK(overlaps(Triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, Pose{}, Capsule{{1, 1, -1}, {1, 1, 1}, 0},
                   Pose{}));
    CHECK(overlaps(Triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, Pose{}, Capsule{{2, 2, -1}, {2, 2, 1}, 0},
                   Pose{}));
    CHECK(!overlaps(Triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, Pose{}, Capsule{{2.5, 2, -1}, {2.5, 2, 1}, 0},
                    Pose{}));
}

TEST_CASE("overlap: says what distance says")
{
    support::Random random(5);
    int yes = 0, no = 0;
    for (int i = 0; i < 40'000; ++i) {
        const double r = random.between(0, 1);
        const Vec3 p = random.in_cube(1), q = random.in_cube(1), n = random.unit(),
                   position = random.in_cube(2);
        const Quat turn = random.rotation();
        const Shape shapes[] = {Sphere{r},         Capsule{p, q, r}, Box{p.cwiseAbs()},
                                Triangle{p, q, n}, Plane{n, r},      HalfSpace{n, r}};
        const Shape &a = shapes[i % 4], &b = shapes[i / 4 % 6];
        const double gap = distance(a, {position, turn}, b, Pose{}).gap;
        CAPTURE(i);
        if (std::fabs(gap) > 1e-14) CHECK(overlaps(a, {position, turn}, b, Pose{}) == (gap < 0));
        yes += gap < 0;
        no += gap > 0;
    }
    CHECK(yes > 10'000);
    CHECK(no > 10'000);
}

TEST_CASE("overlap: in doubt, true")
{
    CHECK(overlaps(Sphere{not_a_number}, Pose{}, Sphere{1}, at(9, 0, 0)));
    CHECK(overlaps(Sphere{-1}, Pose{}, Sphere{1}, at(9, 0, 0)));
    CHECK(overlaps(Sphere{1}, at(infinity, 0, 0), Box{{1, 1, 1}}, Pose{}));
    CHECK(overlaps(Plane{{0, 0, 1}, 5}, Pose{}, HalfSpace{}, Pose{}));
}
