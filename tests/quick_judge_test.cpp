// SPDX-License-Identifier: BSD-3-Clause
#include "support/quick_judge.h"

#include "support/quick_walk.h"
#include "support/random.h"
#include "support/reference.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

using namespace brink;
using namespace brink::support;

namespace {

bool acquitted(const Query& q, const Toi& toi) { return quick_judge(q, toi).acquittal != Acquittal::none; }

Query drawn(const Pair& pair, std::uint64_t index)
{
    return index % 2 == 0 ? query(pair, Family::any, 20261127, index)
                          : campaign_query(pair, 20261127, index, Aim::quick);
}

/// How fast the gap closes just before t.
double closing_speed(const Query& q, double t)
{
    const GapOverTime motion(q);
    constexpr Real moment = 1e-6L;
    return static_cast<double>((motion.at(t - moment).gap - motion.at(t).gap) / moment);
}

/// Hits that do not graze, at whose time nothing may be moved by 1e-6 unseen.
std::vector<Query> plain_hits(const Pair& pair, std::size_t wanted)
{
    std::vector<Query> out;
    for (std::uint64_t i = 0; i < 2000 && out.size() < wanted; ++i) {
        Query q = drawn(pair, i);
        q.options.tolerance = std::min(q.options.tolerance, 1e-9);
        if (q.options.start_contact != StartContact::report) continue;
        const Toi toi = answer(q);
        if (toi.status != Status::hit || toi.t < 1e-3 || toi.t > 0.999 * q.options.t_max) continue;
        const GapOverTime motion(q);
        const bool small = motion.scale() < 100;
        if (small && closing_speed(q, toi.t) > 0.5 && acquitted(q, toi)) out.push_back(q);
    }
    return out;
}

std::vector<Pair> judged_pairs()
{
    std::vector<Pair> out;
    for (const Pair& pair : all_pairs())
        if (!pair.unbounded()) out.push_back(pair);
    return out;
}

/// The time before t at which the gap is `over` the target.
double before_contact(const Query& q, double t, double over)
{
    const GapOverTime motion(q);
    double low = t - 1e-3, high = t;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (motion.at(middle).gap - static_cast<Real>(q.options.target_gap) > static_cast<Real>(over) ? low
                                                                                                   : high) =
            middle;
    }
    return low;
}

} // namespace

TEST_CASE("quick judge: an answer late by 1e-6, a miss and an early hit are never acquitted")
{
    for (const Pair& pair : judged_pairs()) {
        CAPTURE(pair.name());
        const std::vector<Query> hits = plain_hits(pair, 20);
        CHECK(hits.size() == 20);
        for (Query q : hits) {
            const Toi right = answer(q);
            q.options.detail = Detail::time_only; // gap, normal and points would tell the times apart
            CHECK(acquitted(q, right));
            Toi wrong = right;
            wrong.t = right.t + 1e-6;
            wrong.t_upper = infinity;
            CHECK(quick_judge(q, wrong).doubt == Doubt::apart);
            wrong.status = Status::separated;
            wrong.t = q.options.t_max;
            CHECK(quick_judge(q, wrong).doubt == Doubt::apart);
            wrong.status = Status::undecided; // safe, but only where it is apart
            CHECK(!acquitted(q, wrong));
            wrong = right;
            wrong.t = before_contact(q, right.t, 10 * std::max(q.options.tolerance, 1e-12));
            CHECK(quick_judge(q, wrong).doubt == Doubt::tight);
        }
    }
}

TEST_CASE("quick judge: a t_upper before contact is never acquitted")
{
    for (const Pair& pair : judged_pairs()) {
        CAPTURE(pair.name());
        int early = 0;
        for (Query q : plain_hits(pair, 10)) {
            const Toi right = answer(q);
            q.options.detail = Detail::time_only;
            q.options.tolerance = 1e-3; // such a time is near enough where no closed form decides
            Toi wrong = right;
            wrong.t = before_contact(q, right.t, 1e-5);
            wrong.t_upper = infinity;
            early += acquitted(q, wrong) ? 1 : 0;
            wrong.t_upper = wrong.t + (right.t - wrong.t) / 2;
            CHECK(!acquitted(q, wrong));
            wrong = right;
            wrong.t_upper = right.t - 1e-6;
            CHECK(quick_judge(q, wrong).doubt == Doubt::form);
        }
        CHECK((early >= 2 || pair.closed_form()));
    }
}

TEST_CASE("quick judge: a wrong gap, normal or point is never acquitted")
{
    for (const Pair& pair : judged_pairs()) {
        CAPTURE(pair.name());
        for (const Query& q : plain_hits(pair, 10)) {
            const Toi right = answer(q);
            Toi wrong = right;
            wrong.gap += 1e-4;
            CHECK(quick_judge(q, wrong).doubt == Doubt::contact);
            wrong = right;
            wrong.normal = -right.normal;
            const bool thin = pair.first == 4 || pair.second == 4; // a point in a plane has both normals
            CHECK((!acquitted(q, wrong) || thin));
            wrong = right;
            wrong.point_a += 1e-3 * right.normal;
            wrong.point_b += 1e-3 * right.normal;
            CHECK(quick_judge(q, wrong).doubt == Doubt::contact);
        }
    }
}

TEST_CASE("quick judge: contact at the start")
{
    const auto sphere_at = [](double x, double by) {
        return Query{Sphere{1}, {{Vec3(x, 0, 0), Quat(1, 0, 0, 0)}, Vec3(by, 0, 0)}, Sphere{1}, {}, {}};
    };
    Query q = sphere_at(1.5, -1);
    Toi miss;
    miss.status = Status::separated;
    miss.t = 1;
    CHECK(!acquitted(q, miss));
    CHECK(acquitted(q, answer(q)));
    q.options.start_contact = StartContact::ignore_if_separating;
    CHECK(!acquitted(q, miss)); // the gap falls
    q = sphere_at(1.5, 1);
    q.options.start_contact = StartContact::ignore;
    CHECK(acquitted(q, miss));
    Toi touch;
    touch.status = Status::touching;
    touch.t_upper = 0;
    CHECK(!acquitted(sphere_at(2.5, 1), touch));
    // Left, and it comes back: half a turn about a far pivot and back into the other.
    q = sphere_at(1.5, 0);
    q.motion_a.pivot = Vec3(0, 3, 0);
    q.motion_a.rotation = Vec3(0, 0, 6.2);
    q.options.start_contact = StartContact::ignore;
    const Toi back = answer(q);
    CHECK(back.status == Status::hit);
    CHECK(acquitted(q, back));
    CHECK(!acquitted(q, miss));
    // Near, and receding: it must not stick.
    q = sphere_at(2 + 1e-10, 1);
    Toi stuck = answer(sphere_at(2 + 1e-10, -1));
    CHECK(stuck.status == Status::hit);
    CHECK(!acquitted(q, stuck));
}

TEST_CASE("quick judge: acquits nearly all answers of hard families")
{
    std::map<Acquittal, int> said;
    for (const Pair& pair : judged_pairs())
        for (std::uint64_t i = 0; i < 100; ++i) {
            const Query q = drawn(pair, i);
            ++said[quick_judge(q, answer(q)).acquittal];
        }
    CHECK(said[Acquittal::strict] > 52 * 70);
    CHECK(said[Acquittal::none] < 52 * 6);
}

TEST_CASE("quick walk: a gap is within its blur of the reference's, and what is proven apart is apart")
{
    int seen = 0, proven = 0;
    double worst = 0;
    for (const Pair& pair : judged_pairs())
        for (std::uint64_t i = 0; i < 60; ++i) {
            const Query q = drawn(pair, i);
            Random random(i);
            const double from = random.between(0, 1), span = random.log_between(1e-4, 1);
            const double to = std::min(1.0, from + span);
            const QuickPair quick(q);
            const GapOverTime motion(q);
            const QuickLook first(quick, from, {}, {0, 0, 0}), last(quick, to, {}, {0, 0, 0});
            const Gap truth = motion.at(from);
            const bool known = truth.points_known && !first.gap.overlap;
            if (known) {
                ++seen;
                const Real low = static_cast<Real>(first.gap.lower) - static_cast<Real>(quick.radii());
                const Real high = static_cast<Real>(first.gap.upper) - static_cast<Real>(quick.radii());
                const Real off =
                    std::max(low - truth.gap, truth.gap - high) / static_cast<Real>(quick.blur());
                worst = std::max(worst, static_cast<double>(off));
            }
            const double level = first.gap.lower - 0.3 * span * random.between(0, 1);
            if (!quick_apart(quick, first, last, level, 200).apart) continue;
            ++proven;
            const Real least = static_cast<Real>(level - quick.radii() - quick.blur());
            for (int k = 0; k <= 40; ++k)
                CHECK(motion.at(from + static_cast<Real>(to - from) * k / 40).gap >= least);
        }
    CHECK(seen > 2000);
    CHECK(proven > 800);
    CHECK(worst < 0.5); // a bound that is met only half way
}
