// SPDX-License-Identifier: BSD-3-Clause
#include "simplex.h"

#include "simplices.h"

#include <doctest/doctest.h>

using namespace brink;
using namespace brink::simplices;

namespace {

Simplex nearest_of(std::initializer_list<V3> points)
{
    Simplex s = simplex_of(points);
    s.reduce();
    return s;
}

/// The least height of a corner over the face opposite to it.
Real thickness(const Simplex& s)
{
    Real least = infinity;
    for (int k = 0; k < 4; ++k) {
        const R3 a = real(s.corners[k].w), b = real(s.corners[(k + 1) % 4].w);
        const R3 c = real(s.corners[(k + 2) % 4].w), d = real(s.corners[(k + 3) % 4].w);
        const Real area = brute::norm(brute::cross(c - b, d - b));
        least = std::min(least, area > 0 ? std::fabs(volume(a, b, c, d)) / area : Real{0});
    }
    return least;
}

} // namespace

TEST_CASE("simplex: the nearest point by corner, edge, face and volume")
{
    CHECK(nearest_of({{1, 2, 3}}).point() == V3{1, 2, 3});
    CHECK(nearest_of({{1, -1, 0}, {1, 3, 0}}).point() == V3{1, 0, 0});
    CHECK(nearest_of({{1, 1, 0}, {1, 3, 0}}).size == 1);

    const Simplex on_edge = nearest_of({{1, -1, 0}, {1, 1, 0}, {3, 0, 0}});
    CHECK(on_edge.size == 2);
    CHECK(on_edge.point() == V3{1, 0, 0});
    const Simplex on_face = nearest_of({{-1, -1, 2}, {3, -1, 2}, {-1, 3, 2}});
    CHECK(on_face.size == 3);
    CHECK(norm(on_face.point() - V3{0, 0, 2}) <= 4 * eps);

    CHECK(nearest_of({{-1, -1, -1}, {3, -1, -1}, {-1, 3, -1}, {-1, -1, 3}}).size == 4);
    const Simplex beside = nearest_of({{1, 0, 0}, {3, -1, -1}, {3, 2, -1}, {3, -1, 2}});
    CHECK(beside.point() == V3{1, 0, 0});
    CHECK(beside.size == 1);
}

TEST_CASE("simplex: what is kept of one to three corners, degenerate ones too, comes as near as they do")
{
    NastyCores draw(5);
    int by_size[4] = {}, exact = 0;
    constexpr int count = 60'000;
    for (int i = 0; i < count; ++i) {
        const V3 p = draw.point(), q = draw.point(), far = draw.point();
        const double s = draw.random.between(-1, 2), little = draw.random.log_between(1e-18, 1);
        const int choice = draw.random.index(5);
        const V3 third = choice == 0   ? q
                         : choice == 1 ? p + s * (q - p)
                         : choice == 2 ? p + s * (q - p) + little * far
                                       : far;
        const Simplex all = i % 3 == 0   ? simplex_of({p})
                            : i % 3 == 1 ? simplex_of({p, choice == 0 ? p + little * q : q})
                                         : simplex_of({p, q, third});
        Simplex least = all;
        least.reduce();
        CAPTURE(i);
        CHECK(std::fabs(weight_sum(least) - 1) <= 4 * eps);
        for (int k = 0; k < least.size; ++k)
            CHECK(least.corners[k].weight >= 0);
        const Real truth = distance(all);
        CHECK(norm(least.point()) >= truth - 4 * eps * scale(all));
        CHECK(norm(least.point()) <= truth + 1e-6 * scale(all));
        exact += norm(least.point()) <= truth + 8 * eps * scale(all);
        ++by_size[least.size];
    }
    CHECK(exact > 0.999 * count); // needles lose digits
    for (const int size : {1, 2, 3})
        CHECK(by_size[size] > 2'000);
}

namespace {

/// A triangle before the origin, and one more corner on the origin's side of it: as GJK finds them. Often
/// flat up to rounding, the origin in its plane or just off it.
Simplex four_corners(NastyCores& draw)
{
    for (;;) {
        const V3 p = draw.point(), q = draw.point(), r = draw.point(), any = draw.point();
        const double x = draw.random.between(0, 1), y = draw.random.between(0, 1 - x);
        const double little = draw.random.log_between(1e-16, 1), other = draw.random.log_between(1e-18, 1);
        const double u = draw.random.between(-1, 2), v = draw.random.between(-1, 2);
        const bool flat = draw.random.chance(0.5);
        const V3 n = cross(q - p, r - p), foot = p + x * (q - p) + y * (r - p) + little * n;
        Simplex s = simplex_of({p - foot, q - foot, r - foot});
        s.reduce();
        if (s.size < 3) continue;
        const V3 in_plane = p + u * (q - p) + v * (r - p) - foot;
        const V3 newest = flat ? in_plane + other * n : any;
        const V3 nearest = nearest_point(s);
        if (!(norm(nearest) > 8 * eps * scale(s))) continue; // near enough for GJK
        if (!(dot(nearest, newest) < norm_squared(nearest))) continue;
        s.add({newest, {}, newest, 3, 3, 0});
        return s;
    }
}

} // namespace

TEST_CASE("simplex: four corners close over the origin where it is inside, and else come as near as they do")
{
    NastyCores draw(6);
    int inside = 0, outside = 0, thin = 0, astray = 0;
    for (int i = 0; i < 30'000; ++i) {
        const Simplex all = four_corners(draw);
        Simplex least = all;
        least.reduce();
        CAPTURE(i);
        const Real truth = depth(all);
        if (least.size < 4) {
            const Real out = truth < 0 ? distance(all) : Real{0};
            CHECK(norm(least.point()) >= out - 8 * eps * scale(all));
            astray += norm(least.point()) > out + 1e-6 * scale(all);
        }
        if (thickness(all) < 1e-3 * scale(all)) {
            ++thin;
            continue;
        }
        const double rounding = 1e-12 * scale(all);
        if (least.size == 4) CHECK(truth > -rounding);
        if (least.size < 4) CHECK(truth < rounding);
        if (least.size < 4) CHECK(norm(least.point()) <= distance(all) + rounding);
        inside += truth > rounding;
        outside += truth < -rounding;
    }
    CHECK(inside > 9'000);
    CHECK(outside > 1'500);
    CHECK(thin > 9'000);
    CHECK(astray < 300); // flat ones: what comes no nearer than the round before is not used
}

TEST_CASE("simplex: told that the origin is outside, four corners never close over it")
{
    NastyCores draw(7);
    int closed = 0, apart = 0;
    for (int i = 0; i < 400'000; ++i) {
        const Simplex all = four_corners(draw);
        if (depth(all) > 0) continue;
        Simplex told = all, alone = all;
        told.reduce(Simplex::Origin::outside);
        alone.reduce();
        CAPTURE(i);
        CHECK(told.size < 4);
        CHECK(std::fabs(weight_sum(told) - 1) <= 4 * eps);
        if (alone.size < 4)
            CHECK(told.point() == alone.point());
        else
            CHECK(norm(told.point()) <= distance(all) + 1e-6 * scale(all));
        closed += alone.size == 4;
        ++apart;
    }
    CHECK(closed > 100); // what it is for
    CHECK(apart > 40'000);
}

TEST_CASE("simplex: where it is short, nearest_point is at right angles to its edge or face")
{
    NastyCores draw(8);
    int tilted = 0, short_ones = 0;
    for (int i = 0; i < 40'000; ++i) {
        const V3 p = load(draw.random.in_cube(1)), q = load(draw.random.in_cube(1));
        const V3 r = load(draw.random.in_cube(1)), away = load(draw.random.unit());
        const double x = draw.random.between(0.1, 0.4), y = draw.random.between(0.1, 0.4);
        const double height = draw.random.log_between(1e-12, 1);
        const bool face = i % 2 == 0;
        const V3 e = q - p, n = face ? cross(e, r - p) : cross(e, away);
        if (!(norm(n) > 0.05)) continue; // slivers have their own rounding
        const V3 foot = p + x * e + (face ? y : 0) * (r - p) + (height / norm(n)) * n;
        Simplex s = face ? simplex_of({p - foot, q - foot, r - foot}) : simplex_of({p - foot, q - foot});
        const Simplex all = s;
        s.reduce();
        if (s.size != all.size) continue;
        const R3 a = real(s.corners[0].w), b = real(s.corners[1].w), c = real(s.corners[2].w);
        const R3 edge = brute::unit(b - a);
        const R3 normal =
            face ? brute::unit(brute::cross(b - a, c - a)) : brute::unit(brute::across(a, edge));
        const R3 truth = brute::dot(normal, a) * normal;
        const auto off = [&](V3 v) {
            const R3 u = brute::unit(real(v));
            return face ? brute::norm(brute::cross(u, normal)) : std::fabs(brute::dot(u, edge));
        };
        CAPTURE(i);
        CHECK(brute::norm(real(nearest_point(s)) - truth) <= 8 * eps);
        CHECK(brute::norm(real(s.point()) - truth) <= 8 * eps);
        CHECK(off(nearest_point(s)) <= 64 * eps);
        tilted += off(s.point()) > 1e-10;
        short_ones += height < 1e-8;
    }
    CHECK(short_ones > 5'000);
    CHECK(tilted > 3'000); // as point() is
}

TEST_CASE("simplex: depth is that of the nearest face, below zero outside, and none without a volume")
{
    CHECK(simplex_of({{-1, -1, -1}, {3, -1, -1}, {-1, 3, -1}, {-1, -1, 3}}).depth() ==
          doctest::Approx(1 / std::sqrt(3.0)));
    CHECK(simplex_of({{-4, -4, -4}, {0, -4, -4}, {-4, 0, -4}, {-4, -4, 0}}).depth() ==
          doctest::Approx(-8 / std::sqrt(3.0)));
    CHECK(!(simplex_of({{-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}, {1, 1, 0}}).depth() > 0));
    CHECK(simplex_of({{-1, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}).depth() == -infinity);

    NastyCores draw(9);
    int inside = 0, outside = 0, thin = 0, exact = 0;
    for (int i = 0; i < 60'000; ++i) {
        const V3 p = draw.point(), q = draw.point(), r = draw.point(), t = draw.point();
        const double u = draw.random.between(0, 1), v = draw.random.between(0, 1);
        const double w = draw.random.between(-0.5, 1), little = draw.random.log_between(1e-12, 1);
        const V3 top = i % 2 == 0 ? t : p + u * (q - p) + v * (r - p) + little * (t - p);
        const V3 within = p + w * (u * (q - p) + (1 - u) * (v * (r - p) + (1 - v) * (top - p)));
        const Simplex s = simplex_of({p - within, q - within, r - within, top - within});
        const double found = s.depth(), part = static_cast<double>(thickness(s)) / scale(s);
        CAPTURE(i);
        CHECK(found <= thickness(s) / 2 + 32 * eps * scale(s));
        thin += part < 1e-6;
        if (part < 1e-14) continue;
        CHECK(std::fabs(found - depth(s)) <= 16 * eps * scale(s) / part);
        exact += std::fabs(found - depth(s)) <= 16 * eps * scale(s);
        inside += found > 0;
        outside += found < 0;
    }
    CHECK(inside > 20'000);
    CHECK(outside > 10'000);
    CHECK(thin > 5'000);
    CHECK(exact > 59'000);
}
