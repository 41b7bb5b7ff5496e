// SPDX-License-Identifier: BSD-3-Clause
#include "support/moving.h"
#include "support/referee.h"

#include <doctest/doctest.h>

using namespace brink;
using namespace brink::support;

namespace {

double shown(const Digits& x) { return static_cast<double>(x); }

bool same(const Digits& x, const Digits& y) { return abs(x - y) <= Digits("1e-180"); }

const Capsule upright{Vec3(0, 0, -1), Vec3(0, 0, 1), 0.5};
const Box cube{Vec3(1, 1, 1)};
const Triangle flat{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
const Plane ground{Vec3(0, 0, 1), 0};

Query falling(const Shape& a, const Vec3& from, const Vec3& by, const Shape& b)
{
    return {a, moving(from, by), b, resting(), {}};
}

Query swapped(const Query& q) { return {q.b, q.motion_b, q.a, q.motion_a, q.options}; }

/// Contact at t, closing at the given speed, in either order: all exact in 200 digits.
void meets_at(const Query& query, const Digits& t, double speed)
{
    for (const Query& q : {query, swapped(query)}) {
        const Truth truth = support::truth(q);
        CAPTURE(shown(truth.t));
        CHECK(refereed(q));
        CHECK(!truth.started);
        CHECK(truth.meets);
        CHECK(!truth.in_doubt);
        CHECK(same(truth.t, t));
        CHECK(std::abs(shown(truth.closing_speed) - speed) < 1e-14);
        CHECK(same(gap_minus_target(q, truth.t), 0));
    }
}

void misses_by(const Query& query, double least)
{
    for (const Query& q : {query, swapped(query)}) {
        const Truth truth = support::truth(q);
        CHECK(!truth.started);
        CHECK(!truth.meets);
        CHECK(!truth.in_doubt);
        CHECK(same(truth.least_gap, least));
    }
}

} // namespace

TEST_CASE("referee: sphere against sphere by hand")
{
    const Sphere one{1};
    const Query head_on{
        one, moving(Vec3(5, 0, 0), Vec3(-4, 0, 0)), Sphere{0.5}, moving(Vec3(0, 0, 0), Vec3(3, 0, 0)), {}};
    meets_at(head_on, 0.5, 7);
    CHECK(same(truth(head_on).blur, 0));
    // 3-4-5: centres 5 apart at contact, having come 5 of 10 along x past an offset of 3.
    meets_at(falling(Sphere{2}, Vec3(9, 3, 0), Vec3(-10, 0, 0), Sphere{3}), 0.5, 8);
    meets_at(falling(one, Vec3(-3, 2, 0), Vec3(6, 0, 0), one), 0.5, 0); // tangent
    meets_at(falling(one, Vec3(-1, 2, 0), Vec3(3, 0, 0), one), Digits(1) / 3, 0);
    misses_by(falling(one, Vec3(-3, 2.25, 0), Vec3(6, 0, 0), one), 0.25);
    misses_by(falling(one, Vec3(4, 0, 0), Vec3(-1, 0, 0), one), 1); // not yet
    misses_by(falling(one, Vec3(4, 0, 0), Vec3(1, 0, 0), one), 2);  // receding
    Query near = falling(one, Vec3(4, 0, 0), Vec3(-2, 0, 0), one);
    near.options.target_gap = 0.5;
    meets_at(near, 0.75, 2);
    meets_at(falling(one, Vec3(4, 0, 0), Vec3(-2, 0, 0), one), 1, 2); // at t_max, exactly
    near.options.t_max = 0.5;
    misses_by(near, 0.5);
    CHECK(same(truth(near).t, 0.75));
    CHECK(truth(falling(one, Vec3(2, 0, 0), Vec3(1, 0, 0), one)).started);
    CHECK(!truth(falling(one, Vec3(2 + 0x1p-51, 0, 0), Vec3(1, 0, 0), one)).started);
    CHECK(same(truth(falling(one, Vec3(1, 0, 0), Vec3(1, 0, 0), one)).least_gap, -1));
}

TEST_CASE("referee: sphere against capsule by hand")
{
    meets_at(falling(Sphere{0.5}, Vec3(3, 0, 0.25), Vec3(-4, 0, 0), upright), 0.5, 4); // the side
    meets_at(falling(Sphere{0.5}, Vec3(0, 0, 4), Vec3(0, 0, -4), upright), 0.5, 4);    // the end
    // The end's ball, 3-4-5: centre (0, 0, 1), radii 5.
    meets_at(falling(Sphere{4.5}, Vec3(9, 0, 4), Vec3(-10, 0, 0), upright), 0.5, 8);
    meets_at(falling(Sphere{0.5}, Vec3(-2, 1, 0.5), Vec3(4, 0, 0), upright), 0.5,
             0); // along the side, tangent
    misses_by(falling(Sphere{0.5}, Vec3(-2, 1.5, 0.5), Vec3(4, 0, 0), upright), 0.5);
    misses_by(falling(Sphere{0.5}, Vec3(3, 0, -2), Vec3(0, 0, 4), upright), 2); // along the axis
    meets_at(falling(Sphere{0}, Vec3(3, 0, 0), Vec3(-4, 0, 0), Capsule{Vec3(0, 0, -1), Vec3(0, 0, 1), 0}),
             0.75, 4);
    // A capsule that lies along x by a quarter turn about y.
    Query turned = falling(Sphere{0.5}, Vec3(4, 0, 0), Vec3(-4, 0, 0), upright);
    turned.motion_b.start.orientation = Quat(0.5, 0, 0.5, 0);
    CHECK(!refereed(turned));
    turned.motion_b.start.orientation =
        Quat(std::sqrt(0.5), 0, std::sqrt(0.5), 0); // off unit, yet a quarter turn
    meets_at(turned, 0.5, 4);
}

TEST_CASE("referee: sphere against box and triangle by hand")
{
    meets_at(falling(Sphere{0.5}, Vec3(3.5, 0.25, 0.5), Vec3(-4, 0, 0), cube), 0.5, 4); // a face
    meets_at(falling(Sphere{5}, Vec3(9, 5, 0), Vec3(-10, 0, 0), cube), 0.5, 6);         // an edge: (3, 4)
    meets_at(falling(Sphere{7}, Vec3(9, 4, 7), Vec3(-12, 0, 0), cube), 0.5,
             24.0 / 7);                                                        // a corner: (2, 3, 6)
    meets_at(falling(Sphere{0}, Vec3(3, 1, 1), Vec3(-4, 0, 0), cube), 0.5, 4); // along an edge
    misses_by(falling(Sphere{0.5}, Vec3(3, 2, 0), Vec3(-4, 0, 0), cube), 0.5);
    CHECK(same(truth(falling(Sphere{0.5}, Vec3(0.25, 0, 0), Vec3(0, 0, 0), cube)).least_gap, -1.25));

    meets_at(falling(Sphere{1}, Vec3(1, 1, 3), Vec3(0, 0, -4), flat), 0.5, 4);
    meets_at(falling(Sphere{1}, Vec3(1, 1, -3), Vec3(0, 0, 4), flat), 0.5, 4);
    meets_at(falling(Sphere{5}, Vec3(2, -3, 6), Vec3(0, 0, -4), flat), 0.5, 3.2);       // an edge
    meets_at(falling(Sphere{7}, Vec3(-2, -3, 8), Vec3(0, 0, -4), flat), 0.5, 24.0 / 7); // a corner
    meets_at(falling(Sphere{0}, Vec3(1, 1, 1), Vec3(0, 0, -4), flat), 0.25, 4);         // a point through it
    meets_at(falling(Sphere{0}, Vec3(2, 2, 1), Vec3(0, 0, -4), flat), 0.25, 4);         // and through an edge
    misses_by(falling(Sphere{0}, Vec3(5, 0, 1), Vec3(0, 0, -4), flat), 1);
    const Triangle needle{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(1, 0, 0)}; // no area
    meets_at(falling(Sphere{1}, Vec3(2, 0, 3), Vec3(0, 0, -4), needle), 0.5, 4);
}

TEST_CASE("referee: over planes and half-spaces by hand")
{
    const HalfSpace solid{Vec3(0, 0, 1), 0.5};
    meets_at(falling(Sphere{1}, Vec3(0, 0, 3), Vec3(1, 0, -4), ground), 0.5, 4);
    meets_at(falling(Sphere{1}, Vec3(0, 0, -3), Vec3(1, 0, 4), ground), 0.5, 4);
    meets_at(falling(Sphere{0}, Vec3(0, 0, 1), Vec3(0, 0, -4), ground), 0.25, 4);
    meets_at(falling(Sphere{1}, Vec3(0, 0, 3.5), Vec3(1, 0, -4), solid), 0.5, 4);
    meets_at(falling(upright, Vec3(0, 0, 3.5), Vec3(0, 0, -4), ground), 0.5, 4);
    meets_at(falling(upright, Vec3(0, 0, -3.5), Vec3(0, 0, 4), ground), 0.5, 4);
    meets_at(falling(upright, Vec3(0, 0, 4), Vec3(0, 0, -4), solid), 0.5, 4);
    misses_by(falling(Sphere{1}, Vec3(0, 0, 3), Vec3(7, 0, -1), ground), 1);
    misses_by(falling(Sphere{1}, Vec3(0, 0, -3), Vec3(0, 0, -1), ground), 2);
    CHECK(truth(falling(Sphere{1}, Vec3(0, 0, -3), Vec3(0, 0, -1), solid)).started);
    CHECK(same(truth(falling(Sphere{1}, Vec3(0, 0, 3), Vec3(0, 0, -8), ground)).least_gap, -1));
    // A normal that is not quite of unit length: 3-4-5 in tenths, rounded.
    const Plane slope{Vec3(0.6, 0, 0.8), 0};
    const Truth down = truth(falling(Sphere{1}, Vec3(3, 0, 4), Vec3(-6, 0, -8), slope));
    CHECK(down.meets);
    CHECK(ulp_error(down.t, 0.4) < 1);
    CHECK(same(gap_minus_target(falling(Sphere{1}, Vec3(3, 0, 4), Vec3(-6, 0, -8), slope), down.t), 0));
}

TEST_CASE("referee: capsule against capsule by hand")
{
    const Capsule lying{Vec3(-1, 0, 0), Vec3(1, 0, 0), 0.5};
    meets_at(falling(upright, Vec3(3, 0, 0), Vec3(-4, 0, 0), upright), 0.5, 4); // parallel, side by side
    meets_at(falling(upright, Vec3(0, 0, 5), Vec3(0, 0, -4), upright), 0.5, 4); // parallel, end to end
    meets_at(falling(upright, Vec3(0, 3, 0), Vec3(0, -4, 0), lying), 0.5, 4);   // crossed
    meets_at(falling(upright, Vec3(2, 3, 0.5), Vec3(-2, -4, 0), lying), 0.5,
             4);                                                              // crossed, at the end of one
    meets_at(falling(upright, Vec3(4, 0, 0), Vec3(-4, 0, 0), lying), 0.5, 4); // on end
    misses_by(falling(upright, Vec3(2, -2, 0), Vec3(0, 4, 0), upright), 1);
    CHECK(same(truth(falling(upright, Vec3(0, 0, 0), Vec3(4, 0, 0), lying)).least_gap, -1));
}

TEST_CASE("referee: says when rounding decides, and only then")
{
    // Turned by (2, 0, 0, 1) / sqrt(5), exactly 3-4-5: the end lies at (3, 4, 0), a sphere of radius 1
    // touches it.
    const double fifth = std::sqrt(0.2);
    const Capsule needle{Vec3(0, 0, 0), Vec3(5, 0, 0), 0};
    Query q = falling(Sphere{1}, Vec3(3, 5, 0), Vec3(0, 1, 0), needle);
    q.motion_b.start.orientation = Quat(2 * fifth, 0, 0, fifth);
    CHECK(truth(q).in_doubt);
    const Toi miss{.status = Status::separated, .t = 1};
    CHECK(verify(q, miss).empty());
    q.options.detail = Detail::time_only;
    CHECK(verify(q, {.status = Status::touching, .t = 0}).empty());
    q.motion_a.start.position.y() = std::nextafter(5, 6);
    CHECK(!truth(q).in_doubt);
    CHECK(!truth(q).started);
    CHECK(!verify(q, {.status = Status::touching, .t = 0}).empty());

    // A quarter turn by a quaternion off unit is exact.
    q.motion_b.start.orientation = Quat(std::sqrt(0.5), 0, 0, std::sqrt(0.5));
    q.motion_a.start.position = Vec3(0, 6, 0);
    CHECK(!truth(q).in_doubt);
    CHECK(truth(q).started);

    // Small is not in doubt; smaller than 200 digits of the scale is.
    const double little = 0x1p-334;
    const Query close{Sphere{little}, resting(Vec3(2 * little, 0, 0)), Sphere{0.5 * little}, resting(), {}};
    CHECK(!truth(close).started);
    CHECK(!truth(close).in_doubt);
    const Query shifted = falling(Sphere{1}, Vec3(2, std::ldexp(1, -600), 0), Vec3(0, 1, 0), Sphere{1});
    CHECK(truth(shifted).in_doubt); // apart by 2^-1202
}
