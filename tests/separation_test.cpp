// SPDX-License-Identifier: BSD-3-Clause
#include "brute_force.h"
#include "core.h"
#include "random.h"

#include <doctest/doctest.h>

using namespace brink;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr Core::Kind kinds[] = {Core::Kind::point, Core::Kind::segment, Core::Kind::triangle,
                                Core::Kind::box};

Core segment(V3 a, V3 b, double radius = 0) { return core(Capsule{store(a), store(b), radius}); }
Core triangle(V3 a, V3 b, V3 c) { return core(Triangle{store(a), store(b), store(c)}); }
Core at(Core c, V3 position) { return placed(c, {}, position); }
Core scaled(Core c, double factor)
{
    for (V3& point : c.points)
        point = factor * point;
    c.centre = factor * c.centre;
    c.half_extents = factor * c.half_extents;
    c.radius *= factor;
    return c;
}

double distance_from(const Core& c, V3 p)
{
    if (c.kind == Core::Kind::box) {
        const V3 l = into(c.axes, p - c.centre), h = c.half_extents;
        const double x = std::max(0.0, std::fabs(l.x) - h.x), y = std::max(0.0, std::fabs(l.y) - h.y);
        return norm(V3{x, y, std::max(0.0, std::fabs(l.z) - h.z)});
    }
    return static_cast<double>(brute::features(brute::polytope(at(core(Sphere{}), p)), brute::polytope(c)));
}

/// Everything that Separation promises, up to a few ulp of the scale. The answer by brute force is `truth`.
void check(const Separation& s, const Core& a, const Core& b, double truth)
{
    const double rounding = 48 * eps * brute::scale(a, b);
    const V3 closing = s.point_b - s.point_a - s.gap * s.normal;
    const double lower =
        static_cast<double>(brute::along(brute::polytope(a), brute::polytope(b), brute::real(s.normal)));
    CHECK(std::fabs(s.gap - truth) <= rounding);
    CHECK(std::fabs(s.lower - lower) <= rounding);
    CHECK(s.gap - s.lower <= rounding);
    CHECK(std::fabs(norm(s.normal) - 1) <= 4 * eps);
    CHECK(norm(closing) <= rounding);
    CHECK(distance_from(a, s.point_a) <= rounding);
    CHECK(distance_from(b, s.point_b) <= rounding);
}

} // namespace

TEST_CASE("separation: balls, radii and all")
{
    const Separation s = separation(core(Sphere{1}), at(core(Sphere{0.5}), {3, 0, 4}));
    CHECK(s.gap == 3.5);
    CHECK(s.lower == 3.5);
    CHECK(norm(s.normal - V3{0.6, 0, 0.8}) <= eps);
    CHECK(norm(s.point_a - V3{0.6, 0, 0.8}) <= eps);
    CHECK(norm(s.point_b - V3{2.7, 0, 3.6}) <= 2 * eps);

    const Separation inside = separation(core(Sphere{1}), core(Sphere{2}));
    CHECK(inside.gap == -3);
    CHECK(norm(inside.normal) == 1);
    CHECK(norm(inside.point_b - inside.point_a - inside.gap * inside.normal) == 0);
}

TEST_CASE("separation: two crossing segments touch along the normal of both")
{
    const Separation s =
        separation(segment({-1, 0, 0}, {1, 0, 0}, 0.25), segment({0, -1, 0}, {0, 1, 0}, 0.5));
    CHECK(s.gap == -0.75);
    CHECK(s.lower == -0.75);
    CHECK(std::fabs(s.normal.z) == 1);
}

TEST_CASE("separation: exact where the numbers are")
{
    const Core box = core(Box{{1, 2, 3}});
    CHECK(separation(box, at(box, {2, 0, 0})).gap == 0); // face on face
    CHECK(separation(box, at(box, {2, 4, 0})).gap == 0); // edge on edge
    CHECK(separation(box, at(box, {2, 4, 6})).gap == 0); // corner on corner
    CHECK(separation(box, at(box, {1.5, 0.25, 0.5})).gap == -0.5);
    CHECK(separation(box, at(box, {5, 8, 0})).gap == 5); // 3, 4, 5
    CHECK(separation(at(core(Sphere{1}), {0, 0, 5}), box).gap == 1);
    CHECK(separation(at(core(Sphere{1}), {0.5, 0, 0}), box).gap == -1.5); // half a metre deep, and the radius
    CHECK(separation(segment({0, 0, 4}, {0, 5, 4}), box).gap == 1);

    const Core t = triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
    CHECK(separation(t, at(core(Sphere{0.5}), {1, 1, 2})).gap == 1.5);
    CHECK(separation(t, at(t, {0, 0, -3})).gap == 3);
    CHECK(separation(t, at(t, {1, 1, 0})).gap == 0); // in one plane, overlapping: depth 0 across it
    CHECK(std::fabs(separation(t, at(t, {1, 1, 0})).normal.z) == 1);
    CHECK(separation(t, segment({1, 1, -2}, {1, 1, 1})).gap == -1); // pierced
}

TEST_CASE("separation: every kind of core against every kind, nasty ones, by brute force")
{
    NastyCores cores(20261122);
    int apart = 0, overlapping = 0, touching = 0;
    for (int i = 0; i < 24'000; ++i) {
        const auto [a, b] = cores.pair(kinds[i % 4], kinds[i / 4 % 4]);
        CAPTURE(i);
        const double truth = brute::distance(a, b), scale = brute::scale(a, b);
        check(separation(a, b), a, b, truth);
        apart += truth > 1e-9 * scale;
        overlapping += truth < -1e-9 * scale;
        touching += std::fabs(truth) <= 1e-9 * scale;
    }
    CHECK(apart > 12'000);
    CHECK(overlapping > 800);
    CHECK(touching > 4'000);
}

TEST_CASE("separation: the sides exchanged give the same answer")
{
    NastyCores cores(7);
    int overlapping = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto [a, b] = cores.pair(kinds[i % 4], kinds[i / 4 % 4]);
        CAPTURE(i);
        const Separation s = separation(a, b), t = separation(b, a);
        const double rounding = 48 * eps * brute::scale(a, b);
        CHECK(std::fabs(s.gap - t.gap) <= rounding);
        CHECK(std::fabs(s.lower - t.lower) <= rounding);
        overlapping += s.gap < -rounding;
    }
    CHECK(overlapping > 1'000);
}

TEST_CASE("separation: scaled by a power of two, the same bits")
{
    NastyCores cores(11);
    int compared = 0;
    for (int i = 0; i < 10'000; ++i) {
        const auto [a, b] = cores.pair(kinds[i % 4], kinds[i / 4 % 4]);
        const Separation s = separation(a, b);
        if (std::fabs(s.gap) < 1e-17) continue; // what is left of two numbers that cancel may leave the range
        for (const double factor : {0x1p-700, 0x1p-60, 0x1p60, 0x1p700}) {
            CAPTURE(i);
            CAPTURE(factor);
            const Separation t = separation(scaled(a, factor), scaled(b, factor));
            CHECK(t.gap == s.gap * factor);
            CHECK(t.normal == s.normal);
            CHECK(t.point_a == factor * s.point_a);
            ++compared;
        }
    }
    CHECK(compared > 20'000);
}

TEST_CASE("separation: a half-space and a plane")
{
    const Border space = border(HalfSpace{{0, 0, 1}, 2});
    const Core capsule = segment({0, 0, 3}, {1, 0, 5}, 0.25);
    const Separation above = separation(capsule, space);
    CHECK(above.gap == 0.75);
    CHECK(above.normal == V3{0, 0, -1});
    CHECK(above.point_a == V3{0, 0, 2.75});
    CHECK(above.point_b == V3{0, 0, 2});
    CHECK(separation(at(capsule, {0, 0, -9}), space).gap == -8.25); // deep inside

    const Border plane = border(Plane{{0, 0, 1}, 2});
    CHECK(separation(capsule, plane).gap == 0.75);
    const Separation below = separation(at(capsule, {0, 0, -9}), plane);
    CHECK(below.gap == 5.75);
    CHECK(below.normal == V3{0, 0, 1});
    CHECK(below.point_a == V3{1, 0, -3.75});
    const Separation across = separation(at(capsule, {0, 0, -1.5}), plane);
    CHECK(across.gap == -0.75); // 1.5 .. 3.5 and the radius: out at the top
    CHECK(across.normal == V3{0, 0, -1});
    CHECK(separation(at(capsule, {0, 0, -2.5}), plane).gap == -0.75); // and at the bottom
    CHECK(separation(at(capsule, {0, 0, -2.5}), plane).normal == V3{0, 0, 1});
}

TEST_CASE("separation: a border's length and place are those of its set")
{
    support::Random random(3);
    for (int i = 0; i < 2'000; ++i) {
        const Vec3 n = random.unit(), p = random.in_cube(4);
        const double length = random.between(1 - 4e-7, 1 + 4e-7), offset = random.between(-3, 3);
        const Quat q = random.rotation();
        const Border b = placed(border(Plane{length * n, length * offset}), rotation(q), load(p));
        const V3 on_plane = rotation(q) * (offset * load(n)) + load(p);
        CHECK(std::fabs(norm(b.normal) - 1) <= 8 * eps);
        CHECK(std::fabs(dot(b.normal, on_plane) - b.offset) <= 1e-14);
    }
}
