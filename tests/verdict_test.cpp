// SPDX-License-Identifier: BSD-3-Clause
#include "support/verdict.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace brink;
using namespace brink::support;

namespace {

bool has(const Findings& findings, std::string_view check)
{
    return std::any_of(findings.begin(), findings.end(), [&](const Finding& f) { return f.check == check; });
}

Findings against_reference(const Query& q, const Toi& planted)
{
    Trial trial(q, planted);
    return judge_by_reference(trial);
}

/// Hits that are neither grazing nor slow, at whose time nothing may be moved by 1e-6 unseen.
std::vector<Query> plain_hits(const Pair& pair, int wanted)
{
    std::vector<Query> out;
    for (std::uint64_t i = 0; i < 400 && static_cast<int>(out.size()) < wanted; ++i) {
        const Query q = query(pair, Family::any, 20261202, i);
        Trial trial(q);
        const bool hit = trial.toi().status == Status::hit && trial.toi().t > 1e-3 && trial.toi().t < 0.999;
        if (!hit || trial.query().options.tolerance > 1e-9 || trial.query().options.t_max < 1) continue;
        const Reference& ref = trial.referee();
        if (ref.contact && !ref.grazing && ref.closing_speed > 0.5L && ref.least_gap < -1e-3L)
            out.push_back(q);
    }
    return out;
}

std::vector<Pair> referenced_pairs()
{
    std::vector<Pair> out;
    for (const Pair& pair : all_pairs())
        if (pair.has_reference()) out.push_back(pair);
    return out;
}

} // namespace

TEST_CASE("verdict: a time late or early by 1e-6 is seen, for every pair")
{
    for (const Pair& pair : referenced_pairs()) {
        CAPTURE(pair.name());
        const std::vector<Query> hits = plain_hits(pair, 10);
        CHECK(hits.size() == 10);
        for (const Query& q : hits) {
            Toi toi = answer(q);
            CHECK(!has(against_reference(q, toi), "late"));
            CHECK(!has(against_reference(q, toi), "early"));
            const double t = toi.t;
            toi.t = t + 1e-6;
            toi.t_upper = infinity;
            CHECK(has(against_reference(q, toi), "late"));
            toi.t = t - 1e-6;
            CHECK(has(against_reference(q, toi), "early"));
        }
    }
}

TEST_CASE("verdict: a hit reported as a miss is seen, for every pair")
{
    for (const Pair& pair : referenced_pairs()) {
        CAPTURE(pair.name());
        for (const Query& q : plain_hits(pair, 10)) {
            Toi toi;
            toi.status = Status::separated;
            toi.t = q.options.t_max;
            CHECK(has(against_reference(q, toi), "missed a hit"));
        }
    }
}

TEST_CASE("verdict: a wrong normal, gap or point is seen, for every pair")
{
    for (const Pair& pair : referenced_pairs()) {
        CAPTURE(pair.name());
        int tilted = 0;
        const std::vector<Query> hits = plain_hits(pair, 10);
        for (const Query& q : hits) {
            const Toi toi = answer(q);
            Toi wrong = toi;
            wrong.normal = -toi.normal;
            CHECK(has(against_reference(q, wrong), "normal"));
            wrong.normal = (toi.normal + 0.1 * toi.normal.unitOrthogonal()).normalized();
            tilted += has(against_reference(q, wrong), "normal") ? 1 : 0;
            wrong = toi;
            wrong.gap += 1e-6;
            CHECK(has(against_reference(q, wrong), "gap"));
            wrong = toi;
            wrong.point_a -= 1e-3 * toi.normal;
            wrong.point_b += 1e-3 * toi.normal;
            Trial trial(q, wrong);
            CHECK(has(judge_alone(trial), "points"));
        }
        CHECK(tilted >= 5); // where two corners meet many normals are right; a point has them all
    }
}

TEST_CASE("verdict: answers about the start")
{
    const Motion in{{Vec3(1.5, 0, 0), Quat(1, 0, 0, 0)}, Vec3(-1, 0, 0)};
    Query q{Sphere{1}, in, Sphere{1}, {}, {}};
    Toi miss;
    miss.status = Status::separated;
    miss.t = 1;
    CHECK(has(against_reference(q, miss), "touching"));
    q.options.start_contact = StartContact::ignore_if_separating;
    CHECK(has(against_reference(q, miss), "start contact")); // the gap falls
    q.options.start_contact = StartContact::ignore;
    CHECK(against_reference(q, miss).empty());

    Query apart{Sphere{1}, {{Vec3(2.5, 0, 0), Quat(1, 0, 0, 0)}, Vec3(1, 0, 0)}, Sphere{1}, {}, {}};
    Toi touch;
    touch.status = Status::touching;
    touch.t_upper = 0;
    CHECK(has(against_reference(apart, touch), "touching"));
    // Left within the tolerance, and receding: it must not stick.
    apart.motion_a.start.position.x() = 2 + 1e-10;
    apart.options.tolerance = 1e-9;
    Toi stuck;
    stuck.status = Status::hit;
    stuck.normal = Vec3(-1, 0, 0);
    CHECK(has(against_reference(apart, stuck), "sticks"));
}

TEST_CASE("verdict: what brink's own answers must agree on")
{
    const Query q{Sphere{1}, {{Vec3(5, 0, 0), Quat(1, 0, 0, 0)}, Vec3(-6, 0, 0)}, Sphere{1}, {}, {}};
    const Toi toi = answer(q);
    Trial good(q, toi);
    CHECK(judge_alone(good).empty());
    Toi wrong = toi;
    wrong.t = 0.25;
    Trial other_time(q, wrong);
    const Findings findings = judge_alone(other_time);
    CHECK(has(findings, "time_only"));
    CHECK(has(findings, "t_max = t_upper"));
    CHECK(has(findings, "swap"));
    CHECK(has(findings, "rigid motion"));
    wrong = toi;
    wrong.t = 1.5;
    Trial outside(q, wrong);
    CHECK(has(judge_alone(outside), "t"));
    wrong = toi;
    wrong.normal *= 1.001;
    Trial long_normal(q, wrong);
    CHECK(has(judge_alone(long_normal), "normal"));
}
