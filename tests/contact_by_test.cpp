// SPDX-License-Identifier: BSD-3-Clause
#include "contact_by.h"
#include "support/print.h"
#include "support/reference.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <type_traits>

using namespace brink;
using support::GapOverTime;
using support::Query;
using support::Real;
using support::Reference;

namespace {

struct Answer {
    double by = -1;
    bool there = false;   // witness points within the tolerance of contact were seen
    bool unmoved = false; // the course is back where it was
};

template <class A, class B> Answer asked_of(const A& a, const B& b, const Query& q, double t)
{
    using Part = std::decay_t<decltype(part(b))>;
    const auto mover_a = mover(a, q.motion_a);
    const auto mover_b = mover(b, q.motion_b);
    Course<Part> course(mover_a, mover_b, q.options);
    course.go(t);
    using WatchOfPart = std::conditional_t<std::is_same_v<Part, Core>, Watch, BorderWatch>;
    WatchOfPart watch(mover_a.part, mover_b.part, course.radii + course.tolerance);
    const Sight sight = watch.look(course.facing());
    const double gap = course.separated().gap, by = contact_by(course, watch, sight);
    return {by, sight.upper - course.radii <= course.tolerance,
            course.now() == t && course.separated().gap == gap};
}

/// contact_by() of the query's bodies at time t.
Answer asked(const Query& q, double t)
{
    return std::visit(
        [&](const auto& a, const auto& b) -> Answer {
            if constexpr (std::is_same_v<std::decay_t<decltype(part(a))>, Core>) return asked_of(a, b, q, t);
            return {};
        },
        q.a, q.b);
}

/// When the gap is least, as samples and a search between two of them find it.
Real nearest(const GapOverTime& motion)
{
    constexpr int samples = 64;
    Real best = 0, step = Real{1} / samples;
    for (int k = 1; k < samples; ++k)
        if (motion.at(k * step).gap < motion.at(best).gap) best = k * step;
    for (; step > 1e-9L; step /= 2)
        for (const Real t : {std::max(best - step, Real{0}), std::min(best + step, Real{1})})
            if (motion.at(t).gap < motion.at(best).gap) best = t;
    return best;
}

} // namespace

TEST_CASE("contact_by: contact has begun by then, in the reference's long double")
{
    int proven = 0, hits = 0, early = 0, solid = 0;
    for (const support::Pair& pair : support::all_pairs()) {
        if (!pair.has_reference() || pair.unbounded()) continue;
        for (std::uint64_t index = 0; index < 80; ++index) {
            Query q = support::query(pair, support::Family::rotation, 121, index);
            q.options.start_contact = StartContact::report;
            const GapOverTime motion(q);
            const Reference r = support::reference(q, motion);
            if (!r.contact || r.started || !(r.closing_speed > 1e-6L)) continue;
            const double back =
                0.5 * std::min(q.options.tolerance, 1e-6) / static_cast<double>(r.closing_speed);
            const double t = std::max(0.0, static_cast<double>(r.t) - back);
            const Answer answer = asked(q, t);
            CAPTURE(pair.name());
            CAPTURE(index);
            CHECK(answer.unmoved);
            if (!answer.there) continue;
            ++hits;
            if (answer.by < infinity) {
                ++proven;
                solid += q.options.target_gap == 0 && pair.first > 1;
                CHECK(answer.by >= t);
                CHECK(answer.by <= q.options.t_max);
                CHECK(answer.by >= static_cast<double>(r.t) - 1e-15);
                CHECK(motion.at(answer.by).gap <= q.options.target_gap);
            }
            // A step that ends before contact.
            Query shorter = q;
            shorter.options.t_max = t + 0.9 * (static_cast<double>(r.t) - t);
            if (motion.at(shorter.options.t_max).gap <= q.options.target_gap) continue;
            CHECK(asked(shorter, t).by == infinity);
            ++early;
        }
    }
    CHECK(hits > 500);
    CHECK(proven > 0.95 * hits);
    CHECK(solid > 150);
    CHECK(early > 500);
}

TEST_CASE("contact_by: never of bodies that come within the tolerance and no nearer")
{
    int misses = 0;
    for (const support::Pair& pair : support::all_pairs()) {
        if (!pair.has_reference() || pair.unbounded()) continue;
        for (std::uint64_t index = 0; index < 40; ++index) {
            Query q = support::query(pair, support::Family::rotation, 122, index);
            const GapOverTime motion(q);
            const Real t = nearest(motion), least = motion.at(t).gap;
            q.options.tolerance = 1e-8;
            q.options.target_gap = static_cast<double>(least - 1e-10L);
            q.options.t_max = 1;
            q.options.start_contact = StartContact::report;
            if (!(q.options.target_gap >= 0) || motion.scale() > 1e3L) continue;
            const Reference r = support::reference(q, GapOverTime(q));
            if (r.contact || r.gave_up) continue; // nearer elsewhere
            CAPTURE(pair.name());
            CAPTURE(index);
            const double at = static_cast<double>(t), before = std::max(0.0, at - 1e-9);
            for (const double time : {at, before}) {
                const Answer answer = asked(q, time);
                if (!answer.there) continue;
                CHECK(answer.by == infinity);
                ++misses;
            }
        }
    }
    CHECK(misses > 400);
}
