// SPDX-License-Identifier: BSD-3-Clause
#include "hull_proof.h"
#include "random.h"

#include <doctest/doctest.h>

using namespace brink;
using support::Random;

namespace {

const std::vector<Facet> tetrahedron{{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}};
const std::vector<V3> simplex{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

} // namespace

TEST_CASE("side: the exact sign, by a bit")
{
    const V3 a{0.1, 0.2, 0.3}, b{1.1, 0.7, 0.2}, c{-0.3, 0.9, 0.4};
    CHECK(side({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0x1p-1074}) == 1);
    CHECK(side({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, -0x1p-1074}) == -1);
    CHECK(side({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1.7, 0.3, 0}) == 0);
    CHECK(side(a, b, c, c) == 0);
    Random random(95);
    int doubtful = 0;
    for (int i = 0; i < 2'000; ++i) {
        // Quarters of integers about a plane: the determinant is exact in doubles.
        const auto quarter = [&] { return 0.25 * (random.index(9) - 4); };
        V3 p[4];
        for (V3& q : p) {
            const double x = quarter(), y = quarter(), z = quarter();
            q = {x, y, z};
        }
        const double determinant = dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
        CHECK(side(p[0], p[1], p[2], p[3]) == (determinant > 0) - (determinant < 0));
        doubtful += determinant == 0;
    }
    CHECK(doubtful > 50);
}

TEST_CASE("surface: closed or nothing")
{
    CHECK(!Surface(simplex, tetrahedron).empty());
    CHECK(Surface(simplex, {}).empty());
    CHECK(Surface(simplex, {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}}).empty());
    CHECK(Surface(simplex, {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}, {0, 1, 2}}).empty());
    CHECK(Surface(simplex, {{0, 2, 1}, {1, 0, 3}, {1, 2, 3}, {0, 2, 3}}).faces().size() == 4); // turned about
}

TEST_CASE("surface: holds what is inside, its faces too")
{
    const Surface surface(simplex, tetrahedron);
    CHECK(surface.convex());
    CHECK(surface.holds({0.25, 0.25, 0.25}));
    CHECK(surface.holds({0, 0, 0}));
    CHECK(surface.holds({0.25, 0.25, 0.5}));
    CHECK(surface.holds({0.5, 0.25, 0}));
    CHECK(!surface.holds({0.5, 0.25, -0x1p-1074}));
    CHECK(!surface.holds({0.25, 0.25, 0.5 + 0x1p-53}));
}

TEST_CASE("surface: an edge bent inwards is seen, and a flat corner")
{
    // A square pyramid's base as two triangles: about either diagonal, one corner lifted.
    const auto pyramid = [](double lift) {
        return std::vector<V3>{{1, 0, lift}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
    };
    const std::vector<Facet> faces{{0, 1, 2}, {0, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    const auto flat = pyramid(0), up = pyramid(0x1p-50), down = pyramid(-0x1p-50);
    CHECK(Surface(flat, faces).convex());
    CHECK(Surface(up, faces).convex() != Surface(down, faces).convex());

    std::vector<V3> points = simplex;
    points.push_back({0.25, 0.25, 0});
    const Surface with_flat(points, {{0, 1, 4}, {1, 2, 4}, {2, 0, 4}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}});
    CHECK(!with_flat.empty());
    CHECK(with_flat.holds({0.2, 0.2, 0.2}));
    CHECK(!with_flat.convex());
}
