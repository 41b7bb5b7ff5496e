// SPDX-License-Identifier: BSD-3-Clause
#include "reference.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace brink::support {
namespace {

/// Evaluations of the gap after which a walk gives up.
constexpr int most_evaluations = 4000;

struct Sample {
    Real t, gap;
};

/// The least of a convex function on [from, to] by golden section, until it is below `enough`, is known to
/// stay above `far` by the Lipschitz bound, or the bracket is spent.
struct Least {
    Sample best;
    int evaluations;
};

Least least_convex(const std::function<Real(Real)>& f, Real from, Real to, Real enough, Real far, Real speed)
{
    constexpr Real golden = 0.618033988749894848204586834365638118L;
    Sample low{to - golden * (to - from), 0};
    Sample high{from + golden * (to - from), 0};
    low.gap = f(low.t);
    high.gap = f(high.t);
    Sample best{from, f(from)};
    if (const Sample end{to, f(to)}; end.gap < best.gap) best = end;
    int evaluations = 4;
    for (int i = 0; i < 100; ++i) {
        if (low.gap < best.gap) best = low;
        if (high.gap < best.gap) best = high;
        if (best.gap < enough || best.gap - speed * (to - from) > far) break;
        if (low.gap <= high.gap) {
            to = high.t;
            high = low;
            low.t = to - golden * (to - from);
            low.gap = f(low.t);
        } else {
            from = low.t;
            low = high;
            high.t = from + golden * (to - from);
            high.gap = f(high.t);
        }
        if (!(low.t < high.t)) break;
        ++evaluations;
    }
    return {best, evaluations};
}

/// Closing speed just before t (just after, at the start), over 1e-7 of the step.
Real closing_speed(const GapOverTime& motion, Real t)
{
    const Real step = 1e-7L;
    const Real from = std::max<Real>(t - step, 0);
    const Real to = from < t ? t : t + step;
    return (motion.at(from).gap - motion.at(to).gap) / (to - from);
}

Reference with_contact(Reference r, const GapOverTime& motion, Real t)
{
    r.contact = true;
    r.t = t;
    r.closing_speed = closing_speed(motion, t);
    r.grazing = r.closing_speed < 1e-3L * motion.fastest();
    r.evaluations += 2;
    return r;
}

/// First contact of a convex gap that is above the target at 0.
Reference reference_convex(const Query& query, const GapOverTime& motion, Reference r)
{
    const Real target = query.options.target_gap;
    const Real t_max = query.options.t_max;
    const Real deep = target - 1e-6L * motion.scale();
    const Real far = target + 1e-3L * motion.scale();
    const auto f = [&](Real t) { return motion.at(t).gap; };
    const Least least = least_convex(f, 0, t_max, deep, far, motion.fastest());
    r.least_gap = least.best.gap;
    r.evaluations += least.evaluations;
    if (least.best.gap > target + blur(motion)) return r;
    Real apart = 0;
    Real near = least.best.t;
    const Real level = std::max(target, least.best.gap);
    for (int i = 0; i < 120; ++i) {
        const Real middle = (apart + near) / 2;
        if (!(middle > apart && middle < near)) break;
        (f(middle) > level ? apart : near) = middle;
        ++r.evaluations;
    }
    return with_contact(r, motion, near);
}

/// Through the contact at the start: when the gap first exceeds the target, and how far it fell before.
Reference leave_contact(const Query& query, const GapOverTime& motion, Reference r)
{
    const Real target = query.options.target_gap;
    const Real t_max = query.options.t_max;
    Real t = 0;
    Real highest = r.start_gap;
    for (Real here = r.start_gap; here <= target + blur(motion);) {
        if (t >= t_max || r.evaluations >= 40 * most_evaluations) {
            r.t = t_max;
            return r;
        }
        const Real by_speed = motion.fastest() > 0 ? (target - here) / motion.fastest() : t_max;
        t = std::min(t_max, t + std::max<Real>(std::min<Real>(by_speed, 0.01L), 1e-5L));
        here = motion.at(t).gap;
        highest = std::max(highest, here);
        r.drop = std::max(r.drop, highest - here);
        ++r.evaluations;
    }
    r.left = true;
    r.t = t;
    return r;
}

/// The least gap seen after contact: a coarse look over the rest of the step and a fine one just after.
Real least_after(const Query& query, const GapOverTime& motion, const Reference& r)
{
    Real least = std::numeric_limits<Real>::infinity();
    const Real rest = static_cast<Real>(query.options.t_max) - r.t;
    for (int i = 1; r.contact && i <= 16; ++i) {
        least = std::min(least, motion.at(r.t + rest * i / 16).gap);
        least = std::min(least, motion.at(r.t + std::ldexp(rest, -2 * i)).gap);
    }
    return least;
}

} // namespace

Real blur(const GapOverTime& motion) { return 64 * std::numeric_limits<Real>::epsilon() * motion.scale(); }

Reference reference_walk(const Query& query, const GapOverTime& motion, Real from)
{
    const Real target = query.options.target_gap;
    const Real t_max = query.options.t_max;
    Reference r;
    r.least_gap = std::numeric_limits<Real>::infinity();
    Real t = from;
    for (;;) {
        const Gap here = motion.at(t);
        ++r.evaluations;
        r.least_gap = std::min(r.least_gap, here.gap);
        if (here.gap <= target + blur(motion)) return with_contact(r, motion, t);
        if (t >= t_max) break;
        const Real next = t + motion.safe_step(t, here, target, t_max - t);
        if (next == t) return with_contact(r, motion, t);
        t = std::min(next, t_max);
        if (r.evaluations < most_evaluations) continue;
        r.gave_up = true;
        break;
    }
    r.t = t;
    return r;
}

Reference reference(const Query& query, const GapOverTime& motion)
{
    Reference r;
    const Real target = query.options.target_gap;
    r.start_gap = motion.at(0).gap;
    r.least_gap = r.start_gap;
    r.t = query.options.t_max;
    r.started = r.start_gap <= target;
    Real from = 0;
    if (r.started) {
        if (query.options.start_contact == StartContact::report) return with_contact(r, motion, 0);
        r = leave_contact(query, motion, r);
        if (!r.left || motion.translates()) return r; // a convex gap that has left does not return
        from = r.t;
    }
    if (motion.translates()) return reference_convex(query, motion, r);
    Reference walked = reference_walk(query, motion, from);
    walked.start_gap = r.start_gap;
    walked.started = r.started;
    walked.drop = r.drop;
    walked.left = r.left;
    walked.evaluations += r.evaluations;
    walked.least_gap = std::min(walked.least_gap, least_after(query, motion, walked));
    return walked;
}

} // namespace brink::support
