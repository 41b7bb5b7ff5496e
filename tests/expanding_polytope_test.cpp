// SPDX-License-Identifier: BSD-3-Clause
#include "brute_force.h"
#include "expanding_polytope.h"

#include <doctest/doctest.h>

#include <map>
#include <set>
#include <utility>

using namespace brink;
using brute::R3;
using brute::real;
using brute::Real;
using support::Random;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

Simplex::Corner corner_at(V3 w) { return {w, {}, w, 0, 0, 1}; }

/// A polytope with the corners that it was given, in its own order.
struct Grown {
    std::vector<V3> corners;
    ExpandingPolytope polytope;

    explicit Grown(const Simplex::Corner (&first)[4]) : polytope(first)
    {
        for (const Simplex::Corner& c : first)
            corners.push_back(c.w);
        const R3 a = real(corners[0]), b = real(corners[1]), c = real(corners[2]), d = real(corners[3]);
        if (brute::dot(brute::cross(b - a, c - a), d - a) > 0) std::swap(corners[0], corners[1]);
    }
    bool grow(int face, V3 w)
    {
        if (!polytope.grow(face, corner_at(w))) return false;
        corners.push_back(w);
        return true;
    }
    const ExpandingPolytope::Face& face(int i) { return polytope.face(i); }
    /// A place whose face is gone names one corner only.
    bool gone(int i) { return face(i).corner[0] == face(i).corner[1]; }
    std::vector<int> faces()
    {
        std::vector<int> all;
        for (int i = 0; i < polytope.places(); ++i)
            if (!gone(i)) all.push_back(i);
        return all;
    }
    int free_places() { return polytope.places() - static_cast<int>(faces().size()); }
    /// The place of corner k of a face.
    V3 at(int i, int k) { return corners[static_cast<std::size_t>(face(i).corner[k])]; }
    brute::Face triangle(int i) { return {real(at(i, 0)), real(at(i, 1)), real(at(i, 2))}; }
    /// How far a point is beyond a face.
    Real height(int i, V3 w)
    {
        const auto [a, b, c] = triangle(i);
        return brute::dot(brute::unit(brute::cross(b - a, c - a)), real(w) - a);
    }
};

Grown tetrahedron(double size)
{
    const Simplex::Corner first[] = {corner_at({-size, -size, -size}), corner_at({size, size, -size}),
                                     corner_at({size, -size, size}), corner_at({-size, size, size})};
    return Grown(first);
}

/// Whether every edge goes with one face each way round, all faces hang together, and their number is
/// Euler's.
void check_closed(Grown& g)
{
    std::map<std::pair<int, int>, int> owner;
    std::set<int> used;
    const std::vector<int> faces = g.faces();
    for (const int i : faces)
        for (int k = 0; k < 3; ++k) {
            const int from = g.face(i).corner[k], to = g.face(i).corner[(k + 1) % 3];
            CHECK(owner.emplace(std::pair(from, to), i).second);
            used.insert(from);
        }
    for (const auto& [edge, face] : owner)
        CHECK(owner.count({edge.second, edge.first}) == 1);
    CHECK(faces.size() == 2 * used.size() - 4);
    std::set<int> reached{faces[0]};
    std::vector<int> open{faces[0]};
    while (!open.empty()) {
        const int i = open.back();
        open.pop_back();
        for (int k = 0; k < 3; ++k) {
            const auto next = owner.find({g.face(i).corner[(k + 1) % 3], g.face(i).corner[k]});
            if (next != owner.end() && reached.insert(next->second).second) open.push_back(next->second);
        }
    }
    CHECK(reached.size() == faces.size());
}

/// By how much a corner lies beyond a face at most.
Real bulge(Grown& g)
{
    Real most = -infinity;
    for (const int i : g.faces())
        for (const V3 w : g.corners)
            most = std::max(most, g.height(i, w));
    return most;
}

/// The largest height over a face; 0 where there is none above.
Real most_beyond(Grown& g, V3 w)
{
    Real most = 0;
    for (const int i : g.faces())
        if (g.face(i).offset < infinity) most = std::max(most, g.height(i, w));
    return most;
}

/// On a sphere; or first near to it and later farther out, so that many corners vanish at once.
V3 convex_point(Random& random, int choice, int count)
{
    const double reach = random.between(1, 2), far = random.chance(0.1) ? 1 + 0.2 * count : 1;
    return (choice == 0 ? 1 : reach * far) * load(random.unit());
}

} // namespace

TEST_CASE("expanding polytope: grows by a corner at a time until it is full, and stays as it was then")
{
    for (int i = 0; i < 20; ++i) {
        Random random(41, static_cast<std::uint64_t>(i));
        Grown g = tetrahedron(0.5);
        CAPTURE(i);
        bool room = true;
        while (room) {
            const V3 w = load(random.unit());
            const int face = g.polytope.brightest(w);
            REQUIRE(face >= 0);
            room = g.grow(face, w);
            if (room) CHECK(g.polytope.has(corner_at(w)));
            if (g.corners.size() % 16 == 0 || !room) check_closed(g);
        }
        CHECK(g.corners.size() == ExpandingPolytope::most_corners);
        CHECK(bulge(g) <= 8 * eps);
        const V3 last = 3 * load(random.unit());
        const std::vector<int> before = g.faces();
        CHECK(!g.grow(g.polytope.brightest(last), last));
        CHECK(!g.polytope.has(corner_at(last)));
        CHECK(g.faces() == before);
    }
}

TEST_CASE("expanding polytope: closed whatever it swallows, and brightest knows what a point is beyond")
{
    int swallowed = 0, into_free = 0, within = 0, beyond = 0;
    for (int i = 0; i < 400; ++i) {
        Random random(42, static_cast<std::uint64_t>(i));
        Grown g = tetrahedron(0.5);
        CAPTURE(i);
        for (int k = 0; k < 60; ++k) {
            CAPTURE(k);
            const V3 w = convex_point(random, i % 2, k), aside = 1.5 * load(random.unit());
            const int face = g.polytope.brightest(w), other = g.polytope.brightest(aside);
            CHECK(std::fabs(most_beyond(g, w) - (face < 0 ? 0 : g.height(face, w))) <= 64 * eps * norm(w));
            CHECK(std::fabs(most_beyond(g, aside) - (other < 0 ? 0 : g.height(other, aside))) <=
                  64 * eps * norm(w));
            if (most_beyond(g, w) > 1e-12) CHECK(face >= 0);
            // Between the origin, which stays inside, and a place on the surface.
            const std::vector<int> faces = g.faces();
            const int f = faces[static_cast<std::size_t>(random.index(static_cast<int>(faces.size())))];
            const double u = random.between(0, 1), v = random.between(0, 1 - u);
            const double part = random.between(0, 0.999);
            const V3 on = g.at(f, 0) + u * (g.at(f, 1) - g.at(f, 0)) + v * (g.at(f, 2) - g.at(f, 0));
            CHECK(g.polytope.brightest(part * on) == -1);
            ++within;
            if (face < 0) continue;
            ++beyond;
            into_free += g.free_places() > 0;
            REQUIRE(g.grow(face, w));
            check_closed(g);
            swallowed += g.faces().size() < faces.size();
        }
        CHECK(bulge(g) <= 1e-12);
    }
    CHECK(swallowed > 500);
    CHECK(into_free > 1'000);
    CHECK(within > 20'000);
    CHECK(beyond > 15'000);
}

TEST_CASE("expanding polytope: closed whatever rounding decides, on grids and in planes")
{
    NastyCores draw(43);
    int grown = 0, flat = 0;
    for (int i = 0; i < 600; ++i) {
        Grown g = tetrahedron(draw.random.log_between(1e-6, 1));
        CAPTURE(i);
        for (int k = 0; k < 60; ++k) {
            const V3 p = draw.point();
            const double little = draw.random.log_between(1e-18, 1);
            const int choice = i % 3;
            const V3 w = choice == 0   ? p
                         : choice == 1 ? V3{p.x, p.y, little}
                                       : V3{p.x, little * p.y, 0.5 * p.x};
            const int face = g.polytope.brightest(w);
            if (face < 0 || g.polytope.has(corner_at(w))) continue;
            grown += g.grow(face, w);
            check_closed(g);
            for (const int f : g.faces())
                flat += g.face(f).offset == infinity;
        }
    }
    CHECK(grown > 10'000);
    CHECK(flat > 500);
}

TEST_CASE("expanding polytope: around a point it is as near as the nearest of its faces")
{
    int inside = 0, outside = 0;
    for (int i = 0; i < 200; ++i) {
        Random random(44, static_cast<std::uint64_t>(i));
        Grown g = tetrahedron(0.5);
        for (int k = 0; k < 30; ++k) {
            const V3 w = convex_point(random, i % 2, k), p = random.between(0, 2) * load(random.unit());
            const int face = g.polytope.brightest(w);
            if (face >= 0) REQUIRE(g.grow(face, w));
            Real least = infinity;
            for (const int f : g.faces()) {
                const auto [x, y, z] = g.triangle(f);
                least =
                    std::min({least, brute::to_face(real(p), {x, y, z}), brute::to_segment(real(p), {x, y}),
                              brute::to_segment(real(p), {y, z}), brute::to_segment(real(p), {z, x})});
            }
            CAPTURE(i);
            CAPTURE(k);
            CHECK(std::fabs(norm(g.polytope.around(p).v - p) - least) <= 1e-12);
            (most_beyond(g, p) > 0 ? outside : inside) += 1;
        }
    }
    CHECK(inside > 1'500);
    CHECK(outside > 1'500);
}
