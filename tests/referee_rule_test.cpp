// SPDX-License-Identifier: BSD-3-Clause
#include "support/moving.h"
#include "support/print.h"
#include "support/referee_turning.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace brink;
using namespace brink::support;

namespace {

bool says(const Ruling& ruling, std::string_view check)
{
    return std::any_of(ruling.findings.begin(), ruling.findings.end(),
                       [&](const Finding& f) { return f.check == check; });
}

/// A box that turns into a plane on one edge, at asin(1.25 / sqrt 2) - pi / 4 = 0.298 radians: the whole step
/// is one.
Query edge_on_plane()
{
    return {Box{Vec3(0.5, 1, 1)},
            {.start = {Vec3(0, 0, 1.25), Quat(1, 0, 0, 0)}, .rotation = Vec3(1, 0, 0)},
            Plane{Vec3(0, 0, 1), 0},
            resting(),
            {}};
}

/// What may be said of it: the gap at t is 1.25 - cos t - sin t.
Toi hit_at(double t)
{
    const double gap = 1.25 - std::cos(t) - std::sin(t);
    const double y = std::sin(t) - std::cos(t); // of the lowest edge
    Toi out;
    out.status = Status::hit;
    out.t = t;
    out.normal = Vec3(0, 0, -1);
    out.point_a = Vec3(0, y, gap);
    out.point_b = Vec3(0, y, 0);
    out.gap = gap;
    return out;
}

} // namespace

TEST_CASE("turning referee: finds planted wrong answers about a box and a plane")
{
    const Query q = edge_on_plane();
    const Meeting m = meeting(q);
    REQUIRE(m.meets);
    const auto t = static_cast<double>(m.apart);
    const Toi right = hit_at(t - 1e-10);
    CHECK(rule(q, right).findings.empty());
    CHECK(says(rule(q, hit_at(t + 1e-6)), "late"));
    CHECK(says(rule(q, hit_at(t + 1e-15)), "late"));
    CHECK(says(rule(q, hit_at(t - 1e-6)), "early"));
    CHECK(!says(rule(q, hit_at(t - 1e-6)), "late"));

    Toi wrong = right;
    wrong.status = Status::separated;
    wrong.t = q.options.t_max;
    CHECK(says(rule(q, wrong), "missed a hit"));
    wrong = right;
    wrong.status = Status::touching;
    wrong.t = 0;
    CHECK(says(rule(q, wrong), "touching"));
    wrong = right;
    wrong.t_upper = t + 1e-9;
    CHECK(rule(q, wrong).findings.empty());
    wrong.t_upper = t - 1e-11;
    CHECK(says(rule(q, wrong), "t_upper"));
    wrong = right;
    wrong.normal = Vec3(0, 0, 1); // a plane has two sides
    CHECK(says(rule(q, wrong), "normal"));
    wrong = right;
    wrong.gap += 1e-12;
    CHECK(says(rule(q, wrong), "gap"));
    wrong = right;
    wrong.point_a.z() += 1e-10;
    CHECK(says(rule(q, wrong), "points"));
    wrong = right;
    wrong.status = Status::undecided;
    CHECK(rule(q, wrong).findings.empty());
    wrong.t = t + 1e-9;
    CHECK(says(rule(q, wrong), "late"));
    wrong.status = Status::invalid;
    CHECK(!rule(q, wrong).findings.empty());
    wrong = right;
    wrong.t = 2;
    CHECK(says(rule(q, wrong), "t"));
}

TEST_CASE("turning referee: finds planted wrong answers about contact at the start")
{
    // A sphere in the ground that swings out of it, never to come back, or deeper into it first.
    const Vec3 arm(1.5, 0, -0.5);
    Query q{Sphere{0.5},
            {.start = {Vec3(0, 0, 0.75) + arm, Quat(1, 0, 0, 0)}, .rotation = Vec3(0, -2, 0), .pivot = -arm},
            HalfSpace{Vec3(0, 0, 1), 0},
            resting(),
            {}};
    Toi apart;
    apart.status = Status::separated;
    apart.t = 1;
    CHECK(says(rule(q, apart), "touching"));
    Query deep{Ellipsoid{Vec3(1, 2, 3)}, q.motion_a, Cylinder{4, 4}, resting(), {}};
    CHECK(says(rule(deep, apart), "touching"));
    q.options.start_contact = StartContact::ignore;
    CHECK(rule(q, apart).findings.empty());
    Toi touching = answer(q);
    touching.status = Status::touching;
    touching.t = 0;
    CHECK(says(rule(q, touching), "start contact"));
    q.options.start_contact = StartContact::ignore_if_separating;
    CHECK(rule(q, apart).findings.empty());
    q.motion_a.rotation = Vec3(0, 6, 0);
    CHECK(says(rule(q, apart), "start contact"));
    q.options.start_contact = StartContact::ignore; // it comes back by a whole turn
    q.motion_a.rotation = Vec3(0, -6, 0);
    CHECK(says(rule(q, apart), "missed a hit"));
}

TEST_CASE("turning referee: finds a body that sticks")
{
    Query q = edge_on_plane();
    q.motion_a.start.position.z() = 1 + 1e-7;
    q.motion_a.translation = Vec3(0, 0, 9);
    q.options.tolerance = 1e-6;
    Toi stuck = hit_at(0);
    stuck.gap = q.motion_a.start.position.z() - 1;
    stuck.point_a = Vec3(0, 1, stuck.gap);
    stuck.point_b = Vec3(0, 1, 0);
    CHECK(says(rule(q, stuck), "sticks"));
    q.motion_a.translation = Vec3(0, 0, -9);
    CHECK(rule(q, stuck).findings.empty());
}

TEST_CASE("turning referee: contact at the start within 16 eps S of the target is either's, and no other")
{
    int asked = 0;
    for (const char* name : {"sphere-ellipsoid", "cylinder-ellipsoid", "box-cone", "cone-hull"})
        for (std::uint64_t i = 0; i < 60; ++i) {
            Query q = campaign_query(*pair_named(name), 6, i);
            q.options = {.detail = Detail::time_only};
            if (!judgeable(q)) continue;
            const Bracket<Hundred> start = MovingPair<Hundred>(q).at(0);
            if (!start.depth_known || !(start.lower > 0)) continue;
            q.options.target_gap = static_cast<double>(start.upper);
            const auto rounding = 16 * 0x1p-52 * static_cast<double>(MovingPair<Hundred>(q).scale());
            const auto told = [&](Status status, double beyond) { // the target, in roundings
                Query shifted = q;
                shifted.options.target_gap += beyond * rounding;
                Toi toi;
                toi.status = status;
                return says(rule(shifted, toi), "touching");
            };
            if (!(q.options.target_gap > 4 * rounding)) continue;
            CAPTURE(as_cpp(q));
            CHECK(!told(Status::touching, -0.9));
            CHECK(told(Status::touching, -1.1));
            CHECK(!told(Status::hit, 0.9));
            CHECK(told(Status::hit, 1.1));
            ++asked;
        }
    CHECK(asked > 100);
}

TEST_CASE("turning referee: every bracket is narrow and holds what long double finds")
{
    int looked = 0;
    for (const Pair& pair : all_pairs()) {
        if (pair.unbounded()) continue;
        for (std::uint64_t i = 0; i < 6; ++i) {
            const Query q = campaign_query(pair, 5, i);
            if (!judgeable(q)) continue;
            CAPTURE(as_cpp(q));
            const MovingPair<long double> coarse(q);
            const MovingPair<Hundred> fine(q);
            const Bracket<Hundred> gap = fine.at(q.options.t_max);
            const Bracket<long double> seen = coarse.at(q.options.t_max);
            CHECK(bool(gap.lower <= gap.upper + fine.blur()));
            if (!gap.depth_known || !seen.depth_known) continue;
            ++looked;
            CHECK(bool(gap.upper - gap.lower <= 2 * fine.enough()));
            CHECK(bool(Hundred(seen.lower) <= gap.upper + Hundred(coarse.blur())));
            CHECK(bool(Hundred(seen.upper) >= gap.lower - Hundred(coarse.blur())));
        }
    }
    CHECK(looked > 200);
}

TEST_CASE("turning referee: its axes across a needle's edges are at right angles to the longer one")
{
    const Query q{
        Box{Vec3(0x1.82cfbc864528bp-10, 0x1.0539aea7a7baep-3, 0x1.374560a2b284ap-11)},
        Motion{Pose{Vec3(-0x1.448ec7907d07p-3, -0x1.396333489ab96p-2, 0x1.83d47fae48c7p-1),
                    Quat(-0x1.7ffd945fb1259p-8, -0x1.165866bc31173p-2, -0x1.e2fa057bcbd74p-1,
                         -0x1.85dcb581ab3bap-3)},
               Vec3(-0x1.24e24157a86c6p-4, 0x1.f4e5137ea6e39p+0, 0x1.0c591608694e5p-5),
               Vec3(0x1.212dcae803b0fp-3, 0x1.2dcf99b3d657bp-2, 0x1.e0bb80a3a3779p-4),
               Vec3(-0x1.82cfbc864528bp-10, -0x1.0539aea7a7baep-3, 0x1.374560a2b2849p-11)},
        Triangle{Vec3(-0x1.605fd228e8a7fp-26, -0x1.67f64bd1d62dp+0, -0x1.605fd228e8a7fp-26),
                 Vec3(0x1.605fd228e8a7fp-26, 0x1.67f64bd1d62dp+0, 0x1.605fd228e8a7fp-26),
                 Vec3(0x1.605fd228e8a7fp-26, -0x1.605fd228e8a7fp-26, 0x1.605fd228e8a7fp-26)},
        Motion{Pose{Vec3(-0x1.461784166471p-4, -0x1.8164a0322bcep-3, 0x1.9fa65113df3cep-1),
                    Quat(-0x1.7ffd945fb1259p-8, -0x1.165866bc31173p-2, -0x1.e2fa057bcbd74p-1,
                         -0x1.85dcb581ab3bap-3)},
               Vec3(-0x1.24d93122cfe8p-4, 0x1.f4e4ac346865ep+0, 0x1.0c4aa01f4cd4p-5), Vec3(0, 0, 0),
               Vec3(-0x1.1a5f5b5693b32p+0, 0x1.18db44ddd987cp-1, 0x1.3691298c8c87p+0)},
        Options{0x1.43962911cf9edp-1, 0, 0, StartContact::ignore_if_separating, Detail::contact, 256}};
    CHECK(rule(q, answer(q)).findings.empty()); // was ruled to overlap by 2e-13
}
