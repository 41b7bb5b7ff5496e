// SPDX-License-Identifier: BSD-3-Clause
#include "pursuit.h"

#include "two_bodies.h"

#include <algorithm>
#include <array>
#include <doctest/doctest.h>

using namespace brink;
using support::Random;
using enum Feature::Kind;

namespace {

Feature random_feature(Random& random, Feature::Kind kind)
{
    return kind == vertex ? Feature{} : Feature{kind, load(random.unit())};
}

/// Two features on their way, each a direction and a point that go with a body.
struct Moving {
    TwoBodies<Core> bodies;
    Features features;
    V3 on_a, on_b; // about the pivots
    V3 normal;
    double radii;

    /// What went with a body until a time
    static V3 taken(const Mover<Core>& m, V3 x, double from, double to)
    {
        return turned(m.turn, to) * into(turned(m.turn, from), x);
    }
    /// The gap between the features at `t`, put in their places of `now` by turning each vector by itself.
    double gap(double now, double t) const
    {
        const V3 a = taken(bodies.a, on_a, now, t), b = taken(bodies.b, on_b, now, t);
        const V3 of_a = taken(bodies.a, features.of_a.along, now, t);
        const V3 of_b = taken(bodies.b, features.of_b.along, now, t);
        const V3 way = bodies.offset(t) + b - a;
        const Feature::Kind k = features.of_a.kind, l = features.of_b.kind;
        if (k == face) return dot(taken(bodies.a, normal, now, t), way) - radii;
        if (l == face) return dot(taken(bodies.b, normal, now, t), way) - radii;
        if (k == edge && l == edge) {
            const V3 n = cross(of_a, of_b);
            const double side = dot(cross(features.of_a.along, features.of_b.along), normal) < 0 ? -1 : 1;
            return side * dot(n, way) / norm(n) - radii;
        }
        if (!(radii > 0)) return dot(normal, way);
        const V3 e = k == edge ? of_a : of_b;
        return norm(way - dot(way, e) * e) - radii;
    }
    /// What a pursuit follows: a point's height over the pivot of a face's body; of edges times the sine
    /// between them.
    double height(double now, double t) const
    {
        const V3 n =
            features.of_a.kind == face ? taken(bodies.a, normal, now, t) : taken(bodies.b, normal, now, t);
        if (features.of_a.kind == face) return dot(n, bodies.offset(t) + taken(bodies.b, on_b, now, t));
        if (features.of_b.kind == face) return dot(n, bodies.offset(t) - taken(bodies.a, on_a, now, t));
        return (gap(now, t) + radii) * length(now, t);
    }
    double length(double now, double t) const
    {
        if (features.of_a.kind != edge || features.of_b.kind != edge) return 1;
        const V3 e = taken(bodies.a, features.of_a.along, now, t);
        return norm(cross(e, taken(bodies.b, features.of_b.along, now, t)));
    }
    Pursuit pursuit(const Moment<Core>& at, double now) const
    {
        Facing<Core> f = at.facing();
        f.margin = radii;
        return {f, features, on_a, at.offset + on_b, normal, radii, now};
    }
};

Moving random_features(Random& random, int i)
{
    constexpr std::array kinds{vertex, edge, face};
    const Motion motion_a = random_motion(random, 3), motion_b = random_motion(random, 3);
    const Features features{random_feature(random, kinds[static_cast<std::size_t>(i % 3)]),
                            random_feature(random, kinds[static_cast<std::size_t>(i / 3 % 3)])};
    const V3 on_a = load(random.in_cube(1)), on_b = load(random.in_cube(1)), any = load(random.unit());
    const V3 n = features.of_a.kind == face   ? features.of_a.along
                 : features.of_b.kind == face ? features.of_b.along
                                              : any;
    const double radii = random.chance(0.5) ? random.between(0.1, 1) : 0;
    const Mover<Core> a = mover(core(Box{{1, 1, 1}}), motion_a), b = mover(core(Box{{1, 1, 1}}), motion_b);
    return {{a, b}, features, on_a, on_b, n, radii};
}

} // namespace

TEST_CASE("pursuit: the height and its rate are those of the features where they are by then")
{
    Random random(311);
    std::array<int, 9> asked{};
    for (int i = 0; i < 20'000; ++i) {
        const Moving s = random_features(random, i);
        const double now = random.between(0, 1), t = random.chance(0.1) ? now : random.between(0, 1);
        const Moment<Core> at(s.bodies, now);
        const auto [g, length, growing] = s.pursuit(at, now).at(t);
        const double step = 0x1p-18, height = s.height(now, t);
        const double rate = (s.height(now, t + step) - s.height(now, t - step)) / (2 * step);
        CAPTURE(i);
        CHECK(g.time == t);
        CHECK(std::fabs(g.gap.now - height) < 1e-12);
        CHECK(std::fabs(length - s.length(now, t)) < 1e-12);
        const double longer = s.length(now, t + step) - s.length(now, t - step);
        if (length > 0.05 && length < 1) CHECK(std::fabs(growing / length - longer / (2 * step)) < 1e-4);
        if (height < 0.05 || std::fabs(rate) > 50) continue; // where differences do not tell the rate
        CHECK(std::fabs(g.gap.rate - rate) < 1e-5 * (1 + std::fabs(rate)));
        ++asked[static_cast<std::size_t>(i % 9)];
    }
    for (const int n : asked)
        CHECK(n > 500);
}

TEST_CASE("pursuit: where it falls to what is asked for it does")
{
    Random random(312);
    int found = 0, none = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Moving s = random_features(random, i);
        const Moment<Core> at(s.bodies, 0.25);
        const double aim = i % 2 == 0 ? 1e-6 : 1e-10;
        const double t = s.pursuit(at, 0.25).falls_to(aim, 1e-9, 0.25, 1);
        CAPTURE(i);
        if (t < infinity) {
            CHECK(t > 0.25);
            CHECK(t < 1);
            CHECK(std::fabs(s.gap(0.25, t) - aim) < 1e-9);
        }
        found += t < infinity;
        none += t == infinity;
    }
    CHECK(found > 1'000);
    CHECK(none > 1'000);
}
