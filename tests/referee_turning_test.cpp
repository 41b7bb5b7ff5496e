// SPDX-License-Identifier: BSD-3-Clause
#include "support/moving.h"
#include "support/print.h"
#include "support/referee.h"
#include "support/referee_question.h"
#include "support/referee_turning.h"

#include <doctest/doctest.h>

#include <vector>

using namespace brink;
using namespace brink::support;

namespace {

const Plane ground{Vec3(0, 0, 1), 0};

Motion turning(const Vec3& position, const Vec3& rotation, const Vec3& pivot = Vec3(0, 0, 0))
{
    return {.start = {position, Quat(1, 0, 0, 0)}, .rotation = rotation, .pivot = pivot};
}

Query swapped(const Query& q) { return {q.b, q.motion_b, q.a, q.motion_a, q.options}; }

double shown(const Hundred& x) { return static_cast<double>(x); }

/// First contact at t, to 1e-36, in either order, and proven from both sides.
void meets_at(const Query& query, const Hundred& t)
{
    for (const Query& q : {query, swapped(query)}) {
        REQUIRE(judgeable(q));
        const Meeting m = meeting(q);
        CAPTURE(shown(m.by));
        CAPTURE(shown(t));
        CHECK(m.meets);
        CHECK(!m.in_doubt);
        CHECK(bool(m.apart <= t));
        CHECK(bool(m.by >= t));
        CHECK(bool(m.by - m.apart < Hundred("1e-36")));
    }
}

void misses(const Query& query)
{
    for (const Query& q : {query, swapped(query)}) {
        const Meeting m = meeting(q);
        CHECK(!m.meets);
        CHECK(!m.in_doubt);
        CHECK(bool(m.apart == Hundred(q.options.t_max)));
    }
}

/// Height h over the ground of a centre whose body reaches down by a cos + b sin of the angle turned, until
/// they are equal.
Hundred angle_of(const Hundred& h, const Hundred& a, const Hundred& b)
{
    return asin(Hundred(h / sqrt(Hundred(a * a + b * b)))) - atan2(a, b);
}

} // namespace

TEST_CASE("turning referee: a sphere swings about a pivot into a plane")
{
    // About (0, 0, 1), arm 2: the centre's height is 1 - 2 sin(angle), to be 1/2.
    const Query q{Sphere{0.5}, turning(Vec3(2, 0, 1), Vec3(0, 1, 0), Vec3(-2, 0, 0)), ground, resting(), {}};
    meets_at(q, asin(Hundred(0.25)));
    CHECK(bool(meeting(q).closing_speed > Hundred(1.9)));
    Query slower = q;
    slower.motion_a.rotation = Vec3(0, 0.25, 0);
    misses(slower);
    slower.options.target_gap = 0.25; // sin = 1/8
    meets_at(slower, 4 * asin(Hundred(0.125)));
    // The ground swings instead.
    const Query other{Sphere{0.5},
                      resting(Vec3(2, 0, 1)),
                      HalfSpace{Vec3(0, 0, 1), 0},
                      turning(Vec3(0, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1)),
                      {}};
    meets_at(other, asin(Hundred(0.25)));
}

TEST_CASE("turning referee: edges, rims and corners turn into a plane")
{
    const Hundred h = 1.25;
    const Hundred t = angle_of(h, 1, 1);
    const std::vector<Shape> shapes{Box{Vec3(0.5, 1, 1)}, Cylinder{1, 1}};
    for (const Shape& shape : shapes) {
        const Query q{shape, turning(Vec3(0, 0, 1.25), Vec3(1, 0, 0)), ground, resting(), {}};
        meets_at(q, t);
        Query high = q;
        high.motion_a.start.position.z() = 1.4375; // above sqrt 2
        misses(high);
    }
    const Query tilted{Cylinder{1, 0.5}, turning(Vec3(0, 0, 1.1), Vec3(1, 0, 0)), ground, resting(), {}};
    meets_at(tilted, angle_of(Hundred(1.1), 1, Hundred(0.5)));
    const Query cone{Cone{1, 0.5}, turning(Vec3(0, 0, 1.1), Vec3(1, 0, 0)), ground, resting(), {}};
    meets_at(cone, angle_of(Hundred(1.1), 1, Hundred(0.5))); // its base is below
    // An ellipse of half axes a and b turned by x reaches down by sqrt(a^2 cos^2 x + b^2 sin^2 x).
    const Query ellipsoid{
        Ellipsoid{Vec3(1, 2, 1)}, turning(Vec3(0, 0, 1.5), Vec3(1, 0, 0)), ground, resting(), {}};
    meets_at(ellipsoid, asin(sqrt(Hundred(1.25) / 3)));
}

TEST_CASE("turning referee: a capsule sweeps into a sphere")
{
    // The sphere's centre is 1.5 from the pivot, at a right angle: its distance from the axis is 1.5
    // cos(angle).
    const Query q{Capsule{Vec3(0, 0, 0), Vec3(2, 0, 0), 0.25},
                  turning(Vec3(0, 0, 0), Vec3(0, 0, 2)),
                  Sphere{0.25},
                  resting(Vec3(0, 1.5, 0)),
                  {}};
    meets_at(q, acos(Hundred(1) / 3) / 2);
    // Both turn, the sphere about the capsule's pivot: as if the capsule turned by 3.
    Query both = q;
    both.motion_b = turning(Vec3(0, 1.5, 0), Vec3(0, 0, -1), Vec3(0, -1.5, 0));
    meets_at(both, acos(Hundred(1) / 3) / 3);
    // Turning alike they never meet, after a hundred turns.
    both.motion_a.rotation = both.motion_b.rotation = Vec3(0, 0, 628);
    misses(both);
}

TEST_CASE("turning referee: one body in two guises")
{
    Query q{Sphere{0.75},
            moving(Vec3(5, 0.25, 0.5), Vec3(-6, 0, 0.125)),
            Box{Vec3(1, 0.5, 0.25)},
            turning(Vec3(0, 0, 0), Vec3(0.5, 3, -1), Vec3(0.25, 0.125, 0)),
            {}};
    const Meeting m = meeting(q);
    REQUIRE(m.meets);
    q.a = Ellipsoid{Vec3(0.75, 0.75, 0.75)};
    q.motion_a.rotation = Vec3(3, 4, 5);
    meets_at(q, m.by);
    q.a = Sphere{0.75};
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 0.5 : -0.5, (i & 4) != 0 ? 0.25 : -0.25);
    q.b = Hull::from_points(corners);
    meets_at(q, m.by);
}

TEST_CASE("turning referee: the later contact of a pair that starts in contact")
{
    // A sphere swings up out of the ground and down into it on the other side: its height is 0.75 + |arm|
    // sin(angle), and 1/2 at contact.
    const Vec3 arm(1.5, 0, -0.5);
    Query q{Sphere{0.5}, turning(Vec3(0, 0, 0.75) + arm, Vec3(0, -4, 0), -arm), ground, resting(), {}};
    CHECK(meeting(q).started);
    CHECK(bool(meeting(q).by == 0));
    q.options.start_contact = StartContact::ignore;
    const Hundred reach = sqrt(Hundred(2.5));
    const Hundred start = atan2(Hundred(-0.5), Hundred(1.5));
    const Hundred half_turn = acos(Hundred(-1));
    const Meeting m = meeting(q);
    CHECK(m.left);
    CHECK(bool(abs(m.left_by - (asin(Hundred(-0.25 / reach)) - start) / 4) < Hundred("1e-30")));
    const Hundred t = (half_turn + asin(Hundred(0.25 / reach)) - start) / 4;
    meets_at(q, t);
    // The same by iteration: how deep it is at the start is then not known.
    Query curved = q;
    curved.a = Ellipsoid{Vec3(0.5, 0.5, 0.5)};
    curved.b = Box{Vec3(8, 8, 1)};
    curved.motion_b = resting(Vec3(0, 0, -1));
    meets_at(curved, t);
    q.motion_a.rotation = Vec3(0, -3, 0);
    misses(q);
}

TEST_CASE("turning referee: agrees with the referee of the closed forms where nothing turns")
{
    int hits = 0;
    int asked = 0;
    for (const Pair& pair : all_pairs()) {
        if (!pair.closed_form()) continue;
        for (std::uint64_t i = 0; i < 60; ++i) {
            Query q = query(pair, Family::translation, 20261122, i);
            q.options.start_contact = StartContact::report;
            if (!refereed(q) || !judgeable(q)) continue;
            CAPTURE(as_cpp(q));
            const Truth truth = support::truth(q);
            const Meeting m = meeting(q);
            if (truth.in_doubt || m.in_doubt) continue;
            ++asked;
            CHECK(m.started == truth.started);
            CHECK(m.meets == truth.meets);
            if (!m.meets || !truth.meets || m.started) continue;
            ++hits;
            const Hundred t(truth.t.backend());
            CHECK(bool(m.apart <= t + Hundred("1e-60")));
            CHECK(bool(m.by >= t - Hundred("1e-60")));
            const bool grazing = m.closing_speed < Hundred("1e-6");
            CHECK(bool(grazing || m.by - m.apart < Hundred("1e-30")));
        }
    }
    CHECK(asked > 450);
    CHECK(hits > 180);
}

TEST_CASE("referee: a sliver of a simplex, which rounding puts round the origin, is no contact")
{
    const Query q{Sphere{0x1.761e99dc968p-40},
                  Motion{Pose{Vec3(-0x1.739d0ead233eap-1, 0x1.23323c7067da5p+0, 0x1.108eba0dd7e1dp+1),
                              Quat(0x1.483734bb33083p-1, -0x1.58f530b46001p-1, -0x1.19fd7ce6f2b39p-2,
                                   0x1.f2afb593d1e9bp-3)},
                         Vec3(0x1.2b3f0a5e3434cp-6, -0x1.28441ce3a35a9p-5, -0x1.045947d69762p-4),
                         Vec3(0, 0, 0), Vec3(0, 0, 0)},
                  Cylinder{0x1.d0467bde802a3p-1, 0x1.2b3c8e80d738ep+0},
                  Motion{Pose{Vec3(0, 0, 0), Quat(0x1.b71068b05716ap-4, -0x1.126c8248f7d68p-1,
                                                  -0x1.503a47880ab02p-1, 0x1.0a08d5f71d927p-1)},
                         Vec3(-0x1.f996b70bb1b77p-2, 0x1.f48db7ba03415p-1, 0x1.b7deac94322eap+0),
                         Vec3(0, 0, 0), Vec3(0, 0, 0)},
                  Options{1, 0, 0, StartContact::report, Detail::contact, 256}};
    const Stretch s = Question(q).clear(0, 0.59786330090295914); // contact is 2.7e-15 later
    CHECK(!s.contact);
    CHECK(!s.in_doubt);
}
