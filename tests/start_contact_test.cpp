// SPDX-License-Identifier: BSD-3-Clause
#include "start_contact.h"

#include "exact_contact.h"
#include "vector.h"

#include "support/moving.h"
#include "support/query.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

using namespace brink;
using support::moving;
using support::Random;
using support::resting;

namespace {

std::optional<bool> ask(const Shape& a, const Pose& at_a, const Shape& b, const Pose& at_b = {},
                        double target_gap = 0)
{
    Options options;
    options.target_gap = target_gap;
    const Motion motion_a = Motion::still(at_a), motion_b = Motion::still(at_b);
    return in_contact_at_start(brink::Query{a, motion_a, b, motion_b, options});
}
std::optional<bool> ask(const Shape& a, const Vec3& from_b, const Shape& b)
{
    return ask(a, Pose{from_b, Quat(1, 0, 0, 0)}, b);
}

using Whole = XYZ<long long>; // small ones

/// Whether the origin lies in the hull of up to four points, none of which can be left out: those that can
/// are asked about by themselves.
bool in_simplex(const Whole& a, const Whole& b, const Whole& c)
{
    const Whole n = cross(b - a, c - a);
    if (dot(n, a) != 0) return false;
    return dot(n, cross(a, b)) >= 0 && dot(n, cross(b, c)) >= 0 && dot(n, cross(c, a)) >= 0 && dot(n, n) > 0;
}
bool in_simplex(const Whole& a, const Whole& b)
{
    const Whole n = cross(a, b);
    return dot(n, n) == 0 && dot(a, b) <= 0;
}
bool in_simplex(const Whole& a, const Whole& b, const Whole& c, const Whole& d)
{
    const long long of_a = dot(b, cross(c, d)), of_b = -dot(a, cross(c, d)), of_c = dot(a, cross(b, d)),
                    of_d = -dot(a, cross(b, c));
    const bool up = of_a >= 0 && of_b >= 0 && of_c >= 0 && of_d >= 0;
    const bool down = of_a <= 0 && of_b <= 0 && of_c <= 0 && of_d <= 0;
    return (up || down) && of_a + of_b + of_c + of_d != 0;
}
/// Whether it lies in the hull of all: then in that of four of them (C. Caratheodory 1907).
bool in_hull(const std::vector<Whole>& p)
{
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            if (in_simplex(p[i], p[j])) return true;
            for (std::size_t k = 0; k < j; ++k) {
                if (in_simplex(p[i], p[j], p[k])) return true;
                for (std::size_t l = 0; l < k; ++l)
                    if (in_simplex(p[i], p[j], p[k], p[l])) return true;
            }
        }
    return false;
}

Vec3 vec(const Whole& p)
{
    return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

/// A polytope of small whole numbers, turned by a quaternion of such.
struct Drawn {
    Shape shape;
    std::vector<Whole> corners;
    std::array<int, 4> turn; // w, x, y, z
    Whole at;

    Pose pose() const { return {vec(at), Quat(turn[0], turn[1], turn[2], turn[3])}; }
    long long scale() const
    {
        return turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3];
    }
    /// Times that.
    Whole placed(const Whole& p) const
    {
        const long long w = turn[0];
        const Whole u{turn[1], turn[2], turn[3]};
        return scale() * at + 2 * dot(u, p) * u + (w * w - dot(u, u)) * p + 2 * w * cross(u, p);
    }
};

int draw(Random& random, int most) { return random.index(2 * most + 1) - most; }
Whole draw_point(Random& random, int most)
{
    const int x = draw(random, most), y = draw(random, most), z = draw(random, most);
    return {x, y, z};
}

enum class Kind : unsigned char { box, segment, triangle, hull };

Drawn draw_polytope(Random& random, Kind kind)
{
    Drawn out{Sphere{0}, {}, {}, draw_point(random, 3)};
    while (out.scale() == 0)
        for (int& c : out.turn)
            c = draw(random, 1);
    if (kind == Kind::box) {
        const int x = random.index(3), y = random.index(3), z = random.index(3);
        out.shape = Box{Vec3(x, y, z)};
        for (int k = 0; k < 8; ++k)
            out.corners.push_back({(k & 1) != 0 ? x : -x, (k & 2) != 0 ? y : -y, (k & 4) != 0 ? z : -z});
        return out;
    }
    std::vector<Vec3> points;
    for (int k = kind == Kind::segment ? 2 : kind == Kind::triangle ? 3 : 5; k > 0; --k) {
        out.corners.push_back(draw_point(random, 2));
        points.push_back(vec(out.corners.back()));
    }
    if (kind == Kind::segment) out.shape = Capsule{points[0], points[1], 0};
    if (kind == Kind::triangle) out.shape = Triangle{points[0], points[1], points[2]};
    if (kind == Kind::hull) out.shape = Hull::from_points(points);
    return out;
}

/// The corners of B's placed polytope minus A's, times both scales.
std::vector<Whole> difference(const Drawn& a, const Drawn& b)
{
    std::vector<Whole> out;
    for (const Whole& p : a.corners)
        for (const Whole& q : b.corners)
            out.push_back(a.scale() * b.placed(q) - b.scale() * a.placed(p));
    return out;
}

const Box cube{Vec3(1, 1, 1)};

Hull hull_of_cube()
{
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; ++k)
        corners.emplace_back((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1);
    return Hull::from_points(corners);
}

} // namespace

TEST_CASE("start_contact: polytopes in whole numbers, as their difference holds the origin")
{
    constexpr Kind kinds[] = {Kind::box, Kind::segment, Kind::triangle, Kind::hull};
    for (const Kind kind_a : kinds)
        for (const Kind kind_b : kinds) {
            if (kind_a == Kind::box && kind_b == Kind::box) continue; // too many corners to try
            int contacts = 0;
            for (std::uint64_t i = 0; i < 150; ++i) {
                Random random(4, i);
                const Drawn a = draw_polytope(random, kind_a), b = draw_polytope(random, kind_b);
                const std::vector<Whole> corners = difference(a, b);
                const bool contact = in_hull(corners);
                CAPTURE(i);
                CHECK(ask(a.shape, a.pose(), b.shape, b.pose()) == contact);
                CHECK(ask(b.shape, b.pose(), a.shape, a.pose()) == contact);
                contacts += contact ? 1 : 0;
            }
            CHECK(contacts > 0);
            CHECK(contacts < 150);
        }
}

TEST_CASE("start_contact: the pairs of which exact_contact tells more, as it tells")
{
    for (const support::Pair& pair : support::all_pairs()) {
        if (!pair.closed_form()) continue;
        CAPTURE(pair.name());
        int contacts = 0;
        for (std::uint64_t i = 0; i < 400; ++i) {
            const support::Query q = support::query(pair, support::Family::translation, 31, i);
            const Motion a = Motion::still(q.motion_a.start), b = Motion::still(q.motion_b.start);
            Options options = q.options;
            options.t_max = 0;
            const brink::Query start{q.a, a, q.b, b, options};
            const Verdict verdict = exact_contact(start);
            if (verdict.status == Status::undecided) continue;
            CAPTURE(i);
            CHECK(in_contact_at_start(start) == (verdict.status == Status::touching));
            contacts += verdict.status == Status::touching ? 1 : 0;
        }
        CHECK(contacts >= 20);
    }
}

TEST_CASE("start_contact: bodies that touch on a grid are in contact, one place farther they are not")
{
    const Hull hull = hull_of_cube();
    const double beyond = std::nextafter(2, 3);
    for (const Shape& other :
         {Shape(cube), Shape(hull), Shape(Triangle{Vec3(-1, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1)}),
          Shape(Capsule{Vec3(0, 0, -1), Vec3(0, 0, 0.5), 0.5}), Shape(Sphere{1})}) {
        CAPTURE(other.index());
        for (const Shape& below : {Shape(cube), Shape(hull)}) {
            CHECK(ask(other, Vec3(0.25, -0.5, -2), below) == true);
            CHECK(ask(other, Vec3(0.25, -0.5, -beyond), below) == false);
        }
    }
    CHECK(ask(hull, Vec3(3, 0, 1), HalfSpace{Vec3(0, 0, 1), 0}) == true);
    CHECK(ask(hull, Vec3(3, 0, std::nextafter(1, 2)), HalfSpace{Vec3(0, 0, 1), 0}) == false);
    CHECK(ask(hull, Vec3(3, 0, -1), Plane{Vec3(0, 0, 1), 0}) == true);
    CHECK(ask(hull, Vec3(3, 0, std::nextafter(-1, -2)), Plane{Vec3(0, 0, 1), 0}) == false);
}

TEST_CASE("start_contact: radii and the target gap, over a corner, an edge and a face")
{
    const Hull hull = hull_of_cube();
    const Capsule upright{Vec3(0, 0, 0), Vec3(0, 0, 4), 3};
    const auto at = [&](const Vec3& p, double gap) {
        return ask(hull, {-p, Quat(1, 0, 0, 0)}, upright, {}, gap);
    };
    CHECK(at(Vec3(3, 4, 7), 4) == true); // 2-3-6-7 off the corner, 4 of them up to the capsule
    CHECK(at(Vec3(3, 4, 7), std::nextafter(4, 3)) == false);
    CHECK(at(Vec3(4, 5, 0), 2) == true); // 3-4-5 off the edge
    CHECK(at(Vec3(4, 5, 0), std::nextafter(2, 1)) == false);
    CHECK(at(Vec3(6, 0, 0), 2) == true); // 5 off the face
    CHECK(at(Vec3(6, 0, 0), std::nextafter(2, 1)) == false);
}

TEST_CASE("start_contact: of curved shapes only contact is told")
{
    const Cylinder cylinder{1, 2};
    CHECK(ask(cylinder, Vec3(0.5, 0.5, 2), cube) == true); // stands on it
    CHECK(ask(cylinder, Vec3(0, 0, std::nextafter(2, 3)), cube) == std::nullopt);
    CHECK(ask(Box{Vec3(0.1, 0.1, 1)}, Vec3(1.3, -1.3, 2), cylinder) == true); // near its rim
    CHECK(ask(cylinder, Vec3(5, 5, 1), HalfSpace{Vec3(0, 0, 1), 0}) == true);
    CHECK(ask(cylinder, Vec3(5, 5, 1), Plane{Vec3(0, 0, 1), 0}) == true);
    CHECK(ask(cylinder, Vec3(5, 5, 2), Plane{Vec3(0, 0, 1), 0}) == std::nullopt);
    CHECK(ask(Sphere{1}, Vec3(0, 0, 2), cylinder) == true);
    CHECK(ask(cube, Vec3(0, 0, 2), Cone{1, 1}) == true); // on its tip
    CHECK(ask(Cone{1, 1}, Vec3(0, 0, 2), Ellipsoid{Vec3(3, 2, 1)}) == true);
}

TEST_CASE("start_contact: a hull of many corners, which lie in one plane but for rounding")
{
    int contacts = 0;
    for (std::uint64_t i = 0; i < 60; ++i) {
        Random random(5, i);
        const Vec3 normal = random.unit();
        std::vector<Vec3> points{normal};
        for (int k = 0; k < 40; ++k) {
            const Vec3 p = random.in_cube(1);
            points.emplace_back(p - p.dot(normal) * normal);
        }
        const HalfSpace below{normal, -random.between(0, 0x1p-52)};
        const auto meets = [&](const Vec3& p) { return ask(Sphere{0}, p, below) == true; };
        const bool any = std::any_of(points.begin(), points.end(), meets);
        CAPTURE(i);
        CHECK(ask(Hull::from_points(points), Vec3(0, 0, 0), below) == any);
        contacts += any ? 1 : 0;
    }
    CHECK(contacts > 10);
    CHECK(contacts < 60);
}

TEST_CASE("start_contact: spheres' orientations are not looked at; numbers that reach too far tell nothing")
{
    const Hull hull = hull_of_cube();
    const Quat none(0, 0, 0, 0);
    CHECK(ask(Sphere{1}, Pose{Vec3(0, 0, 2), none}, hull) == true);
    CHECK(ask(Sphere{1}, Pose{Vec3(0, 0, std::nextafter(2, 3)), none}, hull) == false);
    const Triangle wide{Vec3(0, 0, 0), Vec3(0x1p-1000, 0, 0), Vec3(0, 0x1p500, 0)};
    CHECK(ask(wide, Vec3(0, 0, 0), cube) == std::nullopt);
}

TEST_CASE("start_contact: bodies that touch on a grid and press are passed over where that is asked for")
{
    const Hull hull = hull_of_cube();
    Options options;
    options.start_contact = StartContact::ignore;
    Motion tip = resting(Vec3(0, 0, 2));
    tip.rotation = Vec3(0.5, 0, 0);
    for (const Motion& motion :
         {moving(Vec3(0, 0, 2), Vec3(0, 0, -1)), moving(Vec3(0, 0, 2), Vec3(1, 0, -0.5)), tip})
        for (const Shape& above : {Shape(cube), Shape(hull), Shape(Cylinder{1, 1}),
                                   Shape(Capsule{Vec3(-1, 0, -0.5), Vec3(1, 0, -0.5), 0.5})}) {
            CAPTURE(above.index());
            CHECK(time_of_impact(above, motion, cube, resting(), options).status == Status::separated);
            // Above by one place they are not in contact, and press into it.
            Motion higher = motion;
            higher.start.position.z() = std::nextafter(2, 3);
            const Toi toi = time_of_impact(above, higher, cube, resting(), options);
            CHECK(toi.status == Status::hit);
            CHECK(toi.t == 0);
        }
}
