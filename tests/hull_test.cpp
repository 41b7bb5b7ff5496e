// SPDX-License-Identifier: BSD-3-Clause
#include "hull_data.h"
#include "random.h"
#include "support.h"

#include <brink/shape.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

using namespace brink;
using support::Random;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
using Points = std::vector<Vec3>;

std::string complaint(const Points& points)
{
    try {
        Hull::from_points(points);
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "";
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

Points cube_corners(double half)
{
    Points out;
    for (unsigned k = 0; k < 8; ++k)
        out.push_back(
            {(k & 1U) != 0 ? half : -half, (k & 2U) != 0 ? half : -half, (k & 4U) != 0 ? half : -half});
    return out;
}

Points on_sphere(Random& random, int count)
{
    Points out;
    for (int i = 0; i < count; ++i)
        out.push_back(random.unit());
    return out;
}

bool proposals() { return Hull::from_points(cube_corners(1)).data()->neighbours.size() > 0; }

/// Whether the farthest corner of the hull along d is as far as the farthest point, up to rounding.
void check_support(Random& random, const Points& points, const Hull& hull, int directions)
{
    const HullData& h = *hull.data();
    for (int i = 0; i < directions; ++i) {
        const V3 d = load(random.unit());
        double most = -infinity, size = 0;
        for (const Vec3& p : points) {
            most = std::max(most, dot(load(p), d));
            size = std::max(size, norm(load(p)));
        }
        const Vec3 found = hull.vertices()[static_cast<std::size_t>(farthest(h, d))];
        CHECK(dot(load(found), d) >= most - 4 * eps * size);
    }
}

/// The same corner however wide the registers are, of equal ones too.
void check_same_corner(Random& random, const Hull& hull)
{
    const Core c = placed(core(hull), rotation(random.rotation()), load(random.in_cube(3)));
    for (int i = 0; i < 200; ++i) {
        const V3 d = i % 2 == 0 ? load(random.unit()) : i % 4 == 1 ? c.axes.x : c.axes.x - c.axes.z;
        const SupportPoint found = farthest(c, d);
        CHECK(found.corner == farthest(*c.hull, into(c.axes, d)));
        CHECK(found.point == corner(c, found.corner));
    }
}

/// The corner of the difference against v is made of those that one hull after the other tells.
void check_corner_of_both(Random& random, const Hull& hull_a, const Hull& hull_b)
{
    const Core a = placed(core(hull_a), rotation(random.rotation()), load(random.in_cube(3)));
    const Core b = placed(core(hull_b), rotation(random.rotation()), load(random.in_cube(3)));
    for (int i = 0; i < 50; ++i) {
        const V3 v = i % 2 == 0 ? load(random.unit()) : i % 4 == 1 ? a.axes.x : b.axes.x - b.axes.z;
        Simplex::Corner both;
        put_corner_of_hulls(both, a, b, v);
        const SupportPoint on_a = farthest(a, v), on_b = farthest(b, -v);
        CHECK(both.w == on_b.point - on_a.point);
        CHECK(both.on_a == on_a.point);
        CHECK(both.on_b == on_b.point);
        CHECK(both.in_a == on_a.corner);
        CHECK(both.in_b == on_b.corner);
        CHECK(both.weight == 1);
    }
}

} // namespace

TEST_CASE("hull: bad input is named")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(contains(complaint({}), "no points"));
    CHECK(
        contains(complaint({{0, 0, 0}, {1, nan, 0}}), "points[1] = (1.000000, nan, 0.000000) is not finite"));
    CHECK(contains(complaint({{infinity, 0, 0}}), "points[0] = (inf"));
    CHECK(contains(complaint(Points((1U << 20U) + 1, Vec3(1, 2, 3))), "1048577 points, more than 2^20"));
    CHECK(complaint(Points(1U << 20U, Vec3(1, 2, 3))).empty());
}

TEST_CASE("hull: what has no volume keeps its points, each once")
{
    CHECK(Hull().vertices().size() == 1);
    CHECK(Hull().vertices()[0] == Vec3(0, 0, 0));
    CHECK(Hull::from_points(Points{{1, 2, 3}, {1, 2, 3}}).vertices().size() == 1);
    CHECK(Hull::from_points(Points{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {0.5, 0.5, 1}})
              .vertices()
              .size() == 5);
    Random random(91);
    Points flat;
    for (int i = 0; i < 500; ++i) {
        const Vec3 p = random.in_cube(1);
        flat.push_back({p.x(), p.y(), p.x() + p.y()});
    }
    check_support(random, flat, Hull::from_points(flat), 100);
}

TEST_CASE("hull: of points on one line the two ends")
{
    const auto kept = [](const Points& points) {
        const Hull hull = Hull::from_points(points);
        return Points(hull.vertices().begin(), hull.vertices().end());
    };
    CHECK(kept({{1, 1, 1}, {3, 3, 3}, {2, 2, 2}, {0, 0, 0}, {1, 1, 1}}) == Points{{3, 3, 3}, {0, 0, 0}});
    Random random(92);
    for (int i = 0; i < 200; ++i) { // twenty points at whole steps, out of order
        const auto whole = [&] { return static_cast<double>(random.index(2001) - 1000); };
        const Vec3 start(whole(), whole(), whole());
        const Vec3 step = i % 3 == 0 ? Vec3(0, whole() + 1001, 0) : Vec3(whole(), whole(), whole() + 1001);
        Points line;
        for (int k = 0; k < 20; ++k)
            line.push_back(std::ldexp(1, i - 100) * (start + (7 * k % 20) * step));
        CHECK(kept(line) == Points{line[0], line[17]});
        line[5].y() = std::nextafter(line[5].y(), infinity); // by so little off it
        CHECK(kept(line).size() == (i % 3 == 0 ? 2 : 20));
    }
    CHECK(core(Hull::from_points(Points{{0, 0, 1}, {0, 0, 3}, {0, 0, 2}, {0, 0, 0}})).kind ==
          Core::Kind::segment);
}

TEST_CASE("hull: a cube with points inside and on its faces is its eight corners")
{
    Random random(92);
    for (const double half : {1.0, 0.1, 1e-300, 1e300, 12345.678}) {
        Points points = cube_corners(half);
        for (int i = 0; i < 300; ++i) {
            Vec3 p = random.in_cube(half);
            if (i % 2 == 0) p[i % 3] = i % 4 < 2 ? half : -half;
            points.push_back(p);
        }
        const Hull hull = Hull::from_points(points);
        CHECK(hull.vertices().size() == (proposals() ? 8 : points.size()));
        CHECK(std::equal(points.begin(), points.begin() + 8, hull.vertices().begin()));
        check_support(random, points, hull, 200);
    }
}

TEST_CASE("hull: no point lies outside, whatever the cloud")
{
    Random random(93);
    int fewer = 0, climbed = 0;
    for (int i = 0; i < 300; ++i) {
        const int count = 4 + random.index(400), kind = i % 6;
        const double little = random.log_between(1e-18, 1e-3);
        const Vec3 far = kind == 5 ? Vec3(1e6 * random.unit()) : Vec3(0, 0, 0);
        Points points;
        for (int k = 0; k < count; ++k) {
            Vec3 p = random.in_cube(1);
            if (kind == 1) p = random.unit();
            if (kind == 2) p = Vec3(p.x(), little * p.y(), little * p.z()); // needles
            if (kind == 3) p = Vec3(p.x(), p.y(), little * p.z());          // all but flat
            if (kind == 4) p = Vec3(std::round(3 * p.x()), std::round(3 * p.y()), std::round(3 * p.z()));
            if (kind == 5) p = far + (k % 2 == 0 ? 1 : little) * p; // far away, with a cluster
            points.push_back(p);
        }
        const Hull hull = Hull::from_points(points);
        CAPTURE(i);
        check_support(random, points, hull, 50);
        fewer += hull.vertices().size() < points.size() / 2;
        climbed += hull.data()->neighbours.empty() ? 0 : 1;
    }
    if (!proposals()) return;
    CHECK(fewer > 100);
    CHECK(climbed > 100);
}

TEST_CASE("hull: ten thousand points on a sphere")
{
    Random random(94);
    const Points points = on_sphere(random, 10'000);
    const Hull hull = Hull::from_points(points);
    CHECK(hull.vertices().size() == points.size());
    CHECK(hull.data()->neighbours.empty() == !proposals());
    check_support(random, points, hull, 300);
}

TEST_CASE("hull: copies share")
{
    const Hull hull = Hull::from_points(cube_corners(1));
    const Hull copy = hull;
    CHECK(copy.data() == hull.data());
    CHECK(copy.vertices().data() == hull.vertices().data());
}

TEST_CASE("hull: the farthest corner is the same in wide registers")
{
    Random random(98);
    Hull last = Hull::from_points(cube_corners(2));
    for (int count = 4; count <= 70; ++count) {
        Points points;
        for (int i = 0; i < count; ++i)
            points.emplace_back(random.unit());
        const Hull hull = Hull::from_points(points);
        check_same_corner(random, hull);
        check_corner_of_both(random, Hull::from_points(cube_corners(1)), hull);
        check_corner_of_both(random, hull, last);
        last = hull;
    }
    check_same_corner(random, Hull::from_points(cube_corners(1)));
}
