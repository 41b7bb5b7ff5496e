// SPDX-License-Identifier: BSD-3-Clause
#include "support/print.h"
#include "support/random.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <bit>

using namespace brink;
using namespace brink::support;

namespace {

constexpr std::uint64_t seed = 20261122;
/// The exponents asked are -most to most: sizes of 1 stay far from where numbers are subnormal and from the
/// 1e75 above which lengths are not answered.
constexpr int most = 200;

Vec3 scaled(const Vec3& v, int k)
{
    return {std::ldexp(v.x(), k), std::ldexp(v.y(), k), std::ldexp(v.z(), k)};
}

Shape scaled(const Shape& shape, int k)
{
    struct Times {
        int k;
        Shape operator()(const Sphere& s) const { return Sphere{std::ldexp(s.radius, k)}; }
        Shape operator()(const Capsule& s) const
        {
            return Capsule{scaled(s.a, k), scaled(s.b, k), std::ldexp(s.radius, k)};
        }
        Shape operator()(const Box& s) const { return Box{scaled(s.half_extents, k)}; }
        Shape operator()(const Triangle& s) const
        {
            return Triangle{scaled(s.a, k), scaled(s.b, k), scaled(s.c, k)};
        }
        Shape operator()(const Plane& s) const { return Plane{s.normal, std::ldexp(s.offset, k)}; }
        Shape operator()(const HalfSpace& s) const { return HalfSpace{s.normal, std::ldexp(s.offset, k)}; }
        Shape operator()(const Cylinder& s) const
        {
            return Cylinder{std::ldexp(s.half_length, k), std::ldexp(s.radius, k)};
        }
        Shape operator()(const Cone& s) const
        {
            return Cone{std::ldexp(s.half_length, k), std::ldexp(s.radius, k)};
        }
        Shape operator()(const Ellipsoid& s) const { return Ellipsoid{scaled(s.radii, k)}; }
        Shape operator()(const Hull& s) const
        {
            std::vector<Vec3> points;
            for (const Vec3& p : s.vertices())
                points.push_back(scaled(p, k));
            return Hull::from_points(points);
        }
    };
    return std::visit(Times{k}, shape);
}

Motion scaled(Motion m, int k)
{
    m.start.position = scaled(m.start.position, k);
    m.translation = scaled(m.translation, k);
    m.pivot = scaled(m.pivot, k);
    return m;
}

Query scaled(Query q, int k)
{
    q.a = scaled(q.a, k);
    q.b = scaled(q.b, k);
    q.motion_a = scaled(q.motion_a, k);
    q.motion_b = scaled(q.motion_b, k);
    q.options.target_gap = std::ldexp(q.options.target_gap, k);
    q.options.tolerance = std::ldexp(q.options.tolerance, k);
    return q;
}

Toi scaled(Toi toi, int k)
{
    toi.point_a = scaled(toi.point_a, k);
    toi.point_b = scaled(toi.point_b, k);
    toi.gap = std::ldexp(toi.gap, k);
    return toi;
}

bool same(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
           (std::isnan(a) && std::isnan(b));
}

bool same(const Vec3& a, const Vec3& b)
{
    return same(a.x(), b.x()) && same(a.y(), b.y()) && same(a.z(), b.z());
}

bool same(const Toi& a, const Toi& b)
{
    return a.status == b.status && same(a.t, b.t) && same(a.t_upper, b.t_upper) && same(a.normal, b.normal) &&
           same(a.point_a, b.point_a) && same(a.point_b, b.point_b) && same(a.gap, b.gap) &&
           a.iterations == b.iterations;
}

struct Tally {
    std::uint64_t asked = 0, hits = 0, separated = 0, touching = 0, wrong = 0;
};

/// Asks each pair so many queries, each as drawn and at three other scales: the extremes and one between.
Tally ask(Family family, std::uint64_t queries)
{
    Tally tally;
    for (const Pair& pair : all_pairs()) {
        if (pair.unbounded()) continue;
        for (std::uint64_t i = 0; i < queries; ++i) {
            // Hulls from their vertices, as the scaled ones are: of other points they may have other faces.
            const Query q = scaled(query(pair, family, seed, i), 0);
            const Toi toi = answer(q);
            ++tally.asked;
            tally.hits += toi.status == Status::hit ? 1U : 0U;
            tally.separated += toi.status == Status::separated ? 1U : 0U;
            tally.touching += toi.status == Status::touching ? 1U : 0U;
            Random random(seed, i);
            for (const int k : {-most, random.index(2 * most + 1) - most, most}) {
                const Toi found = answer(scaled(q, k));
                const Toi expected = scaled(toi, k);
                if (same(found, expected)) continue;
                if (++tally.wrong > 10) continue; // enough to look at
                const auto note =
                    fmt::format("{} {}, lengths times 2^{}\n    // found    {}\n    // expected {}",
                                pair.name(), i, k, in_words(found), in_words(expected));
                MESSAGE(as_cpp(q, note));
            }
        }
    }
    return tally;
}

void check(const Tally& tally)
{
    CHECK(tally.wrong == 0);
    CHECK(tally.asked >= 20000);
    CHECK(tally.hits > tally.asked / 3);
    CHECK(tally.separated > tally.asked / 3);
    CHECK(tally.touching > tally.asked / 20);
}

} // namespace

TEST_CASE("scaling: translation, every length times a power of two, the same bits")
{
    check(ask(Family::translation, 500));
}

TEST_CASE("scaling: rotation, every length times a power of two, the same bits")
{
    check(ask(Family::rotation, 400));
}
