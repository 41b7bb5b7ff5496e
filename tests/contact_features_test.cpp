// SPDX-License-Identifier: BSD-3-Clause
#include "brute_force.h"
#include "contact_features.h"
#include "two_bodies.h"

#include <doctest/doctest.h>

#include <set>

using namespace brink;
using brute::R3;
using brute::real;
using brute::Real;
using support::Random;

namespace {

using enum Feature::Kind;

constexpr double eps = std::numeric_limits<double>::epsilon();

/// v after a turn by t times the rotation vector, by Rodrigues' formula.
R3 turned_by(V3 rate, Real t, R3 v)
{
    const R3 w = t * real(rate);
    const Real angle = brute::norm(w);
    if (!(angle > 0)) return v;
    const R3 k = (1 / angle) * w;
    return std::cos(angle) * v + std::sin(angle) * brute::cross(k, v) +
           ((1 - std::cos(angle)) * brute::dot(k, v)) * k;
}

R3 in_sense_of(R3 n, R3 v) { return brute::unit(brute::dot(n, v) < 0 ? Real{-1} * n : n); }

/// Two features that turn, with what leads from one to the other.
struct Draft {
    Feature a, b;
    V3 rate_a, rate_b, v, towards;
};

Draft draft(Random& random, Feature::Kind kind_a, Feature::Kind kind_b)
{
    Draft d;
    const Vec3 along_a = random.unit(), along_b = random.unit(), v = random.in_cube(2);
    const Vec3 rate_a = random.in_cube(3), rate_b = random.in_cube(3), towards = random.unit();
    const double size = random.log_between(1e-6, 1);
    d.a = {kind_a, load(along_a)};
    d.b = {kind_b, load(along_b)};
    d.rate_a = load(rate_a);
    d.rate_b = random.chance(0.2) ? V3{} : load(rate_b);
    d.v = size * load(v);
    d.towards = load(towards);
    return d;
}

/// The axis that the features ask for when each has turned for a time t; `was` is that of now.
R3 asked_for(const Draft& d, Real t, R3 was)
{
    const R3 a = turned_by(d.rate_a, t, real(d.a.along)), b = turned_by(d.rate_b, t, real(d.b.along));
    if (d.a.kind == face) return in_sense_of(a, real(d.towards));
    if (d.b.kind == face) return in_sense_of(b, real(d.towards));
    if (d.a.kind == edge && d.b.kind == edge) return in_sense_of(brute::cross(a, b), real(d.towards));
    if (d.a.kind == edge) return brute::unit(brute::across(was, a));
    if (d.b.kind == edge) return brute::unit(brute::across(was, b));
    return was;
}

/// The sine by which rounding grows: of the angle between the two directions that make the axis.
Real sine(const Draft& d)
{
    const R3 a = real(d.a.along), b = real(d.b.along), v = brute::unit(real(d.v));
    if (d.a.kind == face || d.b.kind == face) return 1;
    if (d.a.kind == edge && d.b.kind == edge) return brute::norm(brute::cross(a, b));
    if (d.a.kind == edge) return brute::norm(brute::cross(a, v));
    return d.b.kind == edge ? brute::norm(brute::cross(b, v)) : Real{1};
}

R3 axis_now(const Draft& d) { return asked_for(d, 0, brute::unit(real(d.v))); }

} // namespace

TEST_CASE("axis_between: the normal of the features, and the spin with which it turns")
{
    Random random(61);
    int asked = 0;
    for (int i = 0; i < 36'000; ++i) {
        constexpr Feature::Kind kinds[] = {vertex, edge, face};
        const Draft d = draft(random, kinds[i % 3], kinds[i / 3 % 3]);
        const TurningAxis axis = axis_between(d.a, d.rate_a, d.b, d.rate_b, d.v, d.towards);
        const R3 truth = axis_now(d);
        const Real part = sine(d);
        if (part < 0.01) continue; // taken for parallel, or nearly so
        CAPTURE(i);
        const R3 normal = real(axis.normal), spin = real(axis.spin);
        CHECK(std::fabs(brute::norm(normal) - 1) <= 4 * eps);
        CHECK(brute::norm(normal - truth) <= 16 * eps / part);
        // Over a short time: the true one turns as the spin says, up to the square of the time.
        constexpr Real h = 1e-6L;
        const R3 change = (1 / (2 * h)) * (asked_for(d, h, truth) - asked_for(d, -h, truth));
        CHECK(brute::norm(brute::cross(spin, normal) - change) <= 1e-8L / (part * part * part));
        ++asked;
    }
    CHECK(asked > 35'000);
}

TEST_CASE("axis_between: glued to a face, at rest between corners")
{
    const V3 rate{1, 2, 3}, other{-2, 1, 0.5}, v{0.5, 0, -2};
    const TurningAxis on_a = axis_between({face, {0, 0, 1}}, rate, {face, {1, 0, 0}}, other, v, v);
    CHECK(on_a.normal == V3{0, 0, -1});
    CHECK(on_a.spin == rate);
    const TurningAxis on_b = axis_between({edge, {0, 0, 1}}, rate, {face, {1, 0, 0}}, other, v, v);
    CHECK(on_b.normal == V3{1, 0, 0});
    CHECK(on_b.spin == other);
    const TurningAxis resting = axis_between({}, rate, {}, other, {0, 0, -2}, {1, 0, 0});
    CHECK(resting.normal == V3{0, 0, -1});
    CHECK(resting.spin == V3{});
}

TEST_CASE("axis_between: parallel edges keep to A and at right angles to it; what gives no axis gives zero")
{
    const V3 rate{1, 2, 3}, other{-2, 1, 0.5};
    const double little = 1e-5;
    const TurningAxis axis =
        axis_between({edge, {0, 0, 1}}, rate, {edge, {little, 0, 1}}, other, {3, 4, 7}, {1, 0, 0});
    CHECK(norm(axis.normal - V3{0.6, 0.8, 0}) <= 4 * eps);
    CHECK(axis.spin == rate);
    CHECK(axis_between({}, rate, {}, other, {}, {1, 0, 0}).normal == V3{});
    CHECK(axis_between({edge, {0, 0, 1}}, rate, {}, other, {0, 0, 2}, {1, 0, 0}).normal == V3{});
}

TEST_CASE("corners: the features of two cores that GJK names, and they go with the bodies")
{
    Random random(62);
    int by_kind[3] = {};
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 half_a = random.in_cube(1), half_b = random.in_cube(1);
        const Box box_a{half_a.cwiseAbs() + Vec3(0.1, 0.1, 0.1)},
            box_b{half_b.cwiseAbs() + Vec3(0.1, 0.1, 0.1)};
        const Motion motion_a = random_motion(random, 0.1), motion_b = random_motion(random, 0.1);
        const V3 at = 5 * load(random.unit());
        const double t = random.between(0, 1);
        const Mover<Core> mover_a = mover(box_a, motion_a), mover_b = mover(box_b, motion_b);
        const Core a = mover_a.turned_to(0), b = placed(mover_b.turned_to(0), {}, at);
        const Closest c = gjk(a, b, {1e-14});
        const Corners corners(c.simplex);
        const Core later_a = mover_a.turned_to(t), later_b = placed(mover_b.turned_to(t), {}, at);
        CAPTURE(i);
        REQUIRE(corners.known());
        const Simplex s = corners.simplex(later_a, later_b);
        std::set<int> used;
        for (int k = 0; k < s.size; ++k) {
            const Simplex::Corner& p = s.corners[k];
            CHECK(p.on_a == corner(later_a, c.simplex.corners[k].in_a));
            CHECK(p.on_b == corner(later_b, c.simplex.corners[k].in_b));
            CHECK(p.w == p.on_b - p.on_a);
            used.insert(p.in_a);
        }
        const Feature feature = corners.features(s).of_a;
        const auto most = std::min<std::size_t>(used.size(), 3);
        CHECK(static_cast<std::size_t>(feature.kind) == most - 1);
        ++by_kind[most - 1];
        if (most == 1) continue;
        const R3 along = real(feature.along);
        CHECK(std::fabs(brute::norm(along) - 1) <= 4 * eps);
        for (const int k : used) {
            const R3 side = real(corner(later_a, k)) - real(corner(later_a, *used.begin()));
            const Real off = most == 2 ? brute::norm(brute::cross(along, side)) : brute::dot(along, side);
            CHECK(std::fabs(off) <= 16 * eps);
        }
    }
    for (const int count : by_kind)
        CHECK(count > 500);
}
