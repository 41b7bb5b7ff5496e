// SPDX-License-Identifier: BSD-3-Clause
#include "random.h"
#include "vector.h"

#include <brink/discrete.h>
#include <doctest/doctest.h>

using namespace brink;
using namespace brink::discrete;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double eps = std::numeric_limits<double>::epsilon();
const Triangle corner{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

using Real = long double;

/// Six times the volume of a tetrahedron: its sign says on which side of abc the point d lies.
Real volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const Real x[3] = {Real{b.x()} - a.x(), Real{b.y()} - a.y(), Real{b.z()} - a.z()};
    const Real y[3] = {Real{c.x()} - a.x(), Real{c.y()} - a.y(), Real{c.z()} - a.z()};
    const Real z[3] = {Real{d.x()} - a.x(), Real{d.y()} - a.y(), Real{d.z()} - a.z()};
    return x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) +
           x[2] * (y[0] * z[1] - y[1] * z[0]);
}

int sign(Real x) { return (x > 0) - (x < 0); }

Vec3 on_grid(support::Random& random, int half)
{
    const int x = random.index(2 * half + 1), y = random.index(2 * half + 1), z = random.index(2 * half + 1);
    return {double(x - half), double(y - half), double(z - half)};
}

} // namespace

TEST_CASE("discrete: balls, exact on a grid, tangency included")
{
    CHECK(overlap(Ball{{0, 0, 0}, 1}, Ball{{3, 4, 0}, 4}));
    CHECK(!overlap(Ball{{0, 0, 0}, 1}, Ball{{3, 4, 0}, 4 - 4 * eps}));
    support::Random random(1);
    int tangent = 0, yes = 0;
    for (int i = 0; i < 50'000; ++i) {
        const Vec3 p = on_grid(random, 9), q = on_grid(random, 9);
        const int r = random.index(8), s = random.index(8), square = static_cast<int>((q - p).squaredNorm());
        CHECK(overlap(Ball{p, double(r)}, Ball{q, double(s)}) == (square <= (r + s) * (r + s)));
        tangent += square == (r + s) * (r + s);
        yes += square <= (r + s) * (r + s);
    }
    CHECK(tangent > 100);
    CHECK(yes > 5'000);
    CHECK(yes < 40'000);
    CHECK(!overlap(Ball{{not_a_number, 0, 0}, 1}, Ball{{0, 0, 0}, 1}));
    CHECK(!overlap(Ball{{0, 0, 0}, infinity}, Ball{{0, 0, 0}, 1}));
}

TEST_CASE("discrete: boxes along the axes, against every cell of a grid")
{
    const Aabb box{{0, 0, 0}, {1, 2, 3}};
    CHECK(overlap(box, Aabb{{1, 2, 3}, {9, 9, 9}})); // a shared corner
    CHECK(!overlap(box, Aabb{{1 + 2 * eps, 0, 0}, {9, 9, 9}}));
    CHECK(overlap(box, Aabb{{-infinity, 0, 0}, {infinity, 0, 0}}));
    CHECK(!overlap(box, Aabb{{not_a_number, 0, 0}, {1, 1, 1}}));
    support::Random random(2);
    int yes = 0;
    for (int i = 0; i < 5'000; ++i) {
        const Vec3 p = on_grid(random, 3), q = on_grid(random, 3), r = on_grid(random, 3),
                   s = on_grid(random, 3);
        const Aabb a{p.cwiseMin(q), p.cwiseMax(q)}, b{r.cwiseMin(s), r.cwiseMax(s)};
        bool shared = false; // integer boxes that overlap share a point of the grid
        for (int k = 0; k < 343; ++k) {
            const Vec3 x(k % 7 - 3, k / 7 % 7 - 3, k / 49 - 3);
            const bool in_a = (a.min.array() <= x.array()).all() && (x.array() <= a.max.array()).all();
            const bool in_b = (b.min.array() <= x.array()).all() && (x.array() <= b.max.array()).all();
            shared = shared || (in_a && in_b);
        }
        CHECK(overlap(a, b) == shared);
        CHECK(overlap(b, a) == shared);
        yes += shared;
    }
    CHECK(yes > 1'000);
    CHECK(yes < 4'000);
}

TEST_CASE("discrete: a ball and a plane")
{
    const Plane plane{{0, 0, 1}, 2};
    CHECK(overlap(Ball{{7, 8, 3}, 1}, plane));
    CHECK(overlap(Ball{{7, 8, 1}, 1}, plane)); // from below
    CHECK(!overlap(Ball{{7, 8, 3 + 4 * eps}, 1}, plane));
    CHECK(overlap(Ball{{0, 0, 2}, 0}, plane));
    CHECK(!overlap(Ball{{0, 0, 2}, not_a_number}, plane));
    CHECK(!overlap(Ball{{0, 0, 2}, 1}, Plane{{0, 0, 0}, 2}));
}

TEST_CASE("discrete: a segment and a plane")
{
    const Plane plane{{0, 0, 1}, 2};
    const SegmentHit hit = first_meeting(Segment{{0, 0, 1}, {4, 8, 5}}, plane);
    CHECK(hit.hit);
    CHECK(hit.t == 0.25);
    CHECK(hit.point == Vec3(1, 2, 2));
    CHECK(first_meeting(Segment{{0, 0, 5}, {0, 0, 2}}, plane).t == 1); // ends on it
    CHECK(first_meeting(Segment{{0, 0, 2}, {0, 0, 5}}, plane).t == 0);
    CHECK(first_meeting(Segment{{0, 0, 2}, {9, 9, 2}}, plane).t == 0); // lies in it
    CHECK(!first_meeting(Segment{{0, 0, 5}, {0, 0, 2 + 4 * eps}}, plane).hit);
    CHECK(!first_meeting(Segment{{0, 0, 5}, {9, 0, 5}}, plane).hit);
    CHECK(first_meeting(Segment{{0, 0, 5}, {9, 0, 5}}, plane).t == infinity);
    CHECK(!first_meeting(Segment{{0, 0, 5}, {0, 0, -infinity}}, plane).hit);
}

TEST_CASE("discrete: a segment and a triangle, with barycentric coordinates")
{
    const SegmentHit hit = first_meeting(Segment{{1, 2, -1}, {1, 2, 3}}, corner);
    CHECK(hit.hit);
    CHECK(hit.t == 0.25);
    CHECK(hit.point == Vec3(1, 2, 0));
    CHECK(hit.barycentric == Vec3(0.25, 0.25, 0.5));
    CHECK(first_meeting(Segment{{1, 2, 3}, {1, 2, -1}}, corner).t == 0.75); // from the other side
    CHECK(first_meeting(Segment{{4, 0, 3}, {4, 0, -1}}, corner).barycentric == Vec3(0, 1, 0));
    CHECK(first_meeting(Segment{{1, 1, 3}, {1, 1, 0}}, corner).t == 1);
    CHECK(!first_meeting(Segment{{1, 1, 3}, {1, 1, 4 * eps}}, corner).hit);
    CHECK(first_meeting(Segment{{-2, 1, 0}, {6, 1, 0}}, corner).t == 0.25); // in its plane
    CHECK(first_meeting(Segment{{-2, 1, 0}, {6, 1, 0}}, corner).barycentric == Vec3(0.75, 0, 0.25));
    CHECK(first_meeting(Segment{{1, 1, 0}, {6, 1, 0}}, corner).t == 0);
    CHECK(!first_meeting(Segment{{-2, 5, 0}, {6, 5, 0}}, corner).hit);
    CHECK(!first_meeting(Segment{{1, 1, 1}, {1, 1, -1}}, Triangle{{0, 0, 0}, {4, 0, 0}, {0, not_a_number, 0}})
               .hit);
}

TEST_CASE("discrete: degenerate segments and triangles")
{
    const Triangle line{{-1, 0, 0}, {1, 0, 0}, {3, 0, 0}}, point{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    CHECK(first_meeting(Segment{{0, -1, 0}, {0, 3, 0}}, line).t == 0.25);
    CHECK(!first_meeting(Segment{{4, -1, 0}, {4, 3, 0}}, line).hit);
    CHECK(first_meeting(Segment{{5, 0, 0}, {-3, 0, 0}}, line).t == 0.25);
    CHECK(first_meeting(Segment{{0, 0, 0}, {2, 4, 6}}, point).t == 0.5);
    CHECK(!first_meeting(Segment{{0, 0, 0}, {2, 4, 5}}, point).hit);
    CHECK(first_meeting(Segment{{1, 1, 0}, {1, 1, 0}}, corner).hit); // a point in the triangle
    CHECK(!first_meeting(Segment{{1, 1, 1}, {1, 1, 1}}, corner).hit);
    CHECK(first_meeting(Segment{{1, 2, 3}, {1, 2, 3}}, point).t == 0);
}

TEST_CASE("discrete: segments against triangles on a grid, by signs of volumes")
{
    support::Random random(20261122);
    int hits = 0, misses = 0, on_edge = 0;
    for (int i = 0; i < 200'000; ++i) {
        const Vec3 a = on_grid(random, 3), b = on_grid(random, 3), c = on_grid(random, 3),
                   p = on_grid(random, 4), q = on_grid(random, 4);
        const int from = sign(volume(a, b, c, p)), to = sign(volume(a, b, c, q));
        if (from == 0 && to == 0) continue; // in one plane, or no triangle: done by hand
        const int ab = sign(volume(p, q, a, b)), bc = sign(volume(p, q, b, c)), ca = sign(volume(p, q, c, a));
        const bool crosses =
            from * to <= 0 && !((ab > 0 || bc > 0 || ca > 0) && (ab < 0 || bc < 0 || ca < 0));
        const SegmentHit hit = first_meeting(Segment{p, q}, Triangle{a, b, c});
        CAPTURE(i);
        CHECK(hit.hit == crosses);
        hits += crosses;
        misses += !crosses;
        on_edge += crosses && (ab == 0 || bc == 0 || ca == 0);
        if (!hit.hit) continue;
        const Vec3 w = hit.barycentric, inside = w.x() * a + w.y() * b + w.z() * c;
        CHECK(std::fabs(w.x() + w.y() + w.z() - 1) <= 4 * eps);
        CHECK(w.minCoeff() >= 0);
        CHECK((inside - hit.point).norm() <= 1e-13);
    }
    CHECK(hits > 10'000);
    CHECK(misses > 50'000);
    CHECK(on_edge > 1'000);
}
