// SPDX-License-Identifier: BSD-3-Clause
#include "referee_question.h"

#include <algorithm>

namespace brink::support {
namespace {

/// Of the scale: nearer than this nothing is decided.
const Hundred doubt{"1e-40"};
/// Of the scale: so far above the target, long double is enough again.
const Hundred plain{"1e-12"};
/// Long double gives way this many blurs above the target.
constexpr int blurs = 8;

/// Until contact is proven just after the walk has come as near as it may.
std::optional<Hundred> contact_after(const MovingPair<Hundred>& pair, const Walk<Hundred>& w,
                                     const Hundred& to)
{
    if (w.closing_speed <= 0) return std::nullopt;
    const Hundred near = std::max(Hundred(doubt * pair.scale()), Hundred(w.gap.upper - pair.target()));
    Hundred step = 4 * near / w.closing_speed;
    for (int i = 0; i < 8; ++i, step *= 4) {
        const Hundred t = std::min(Hundred(w.clear + step), to);
        if (pair.at(t, w.gap.normal).upper <= pair.target()) return t;
    }
    return std::nullopt;
}

/// Between a time of contact and one without: when the gap exceeds the target by next to nothing. By false
/// position with the Illinois weights (M. Dowell, P. Jarratt 1971), halving where a depth is not known.
Hundred crossing(const MovingPair<Hundred>& pair, Hundred low, Hundred high)
{
    const Hundred aim = pair.target() + 100 * doubt * pair.scale();
    const auto over = [&](const Hundred& t) { return pair.at(t); };
    Bracket<Hundred> at_low = over(low);
    Hundred below = at_low.upper - aim;
    Hundred above = over(high).lower - aim;
    for (int i = 0; i < 160 && above > 90 * doubt * pair.scale(); ++i) {
        const bool guess = at_low.depth_known && i % 4 != 3 && below < 0;
        const Hundred t =
            guess ? Hundred((low * above - high * below) / (above - below)) : Hundred((low + high) / 2);
        const Bracket<Hundred> there = over(t);
        const Hundred here = there.lower - aim;
        if (here > -90 * doubt * pair.scale()) {
            high = t;
            above = here;
            below /= 2;
        } else {
            low = t;
            at_low = there;
            below = here;
            above /= 2;
        }
    }
    return high;
}

Vector<Hundred> in_digits(const Bracket<long double>& gap)
{
    return {gap.normal.x, gap.normal.y, gap.normal.z};
}

} // namespace

Question::Over Question::over(double t, const Hundred& level) const
{
    constexpr double share = 0.5; // what side of the level it is on
    const auto near = static_cast<long double>(level) + coarse_.target();
    const Bracket<long double> quick = coarse_.roughly(t, {}, near, share);
    const Hundred lower = Hundred(quick.lower - coarse_.blur()) - fine_.target();
    const Hundred upper = Hundred(quick.upper + coarse_.blur()) - fine_.target();
    if (lower > level || upper <= level) return {lower, upper, !quick.depth_known};
    const Bracket<Hundred> gap = fine_.roughly(t, in_digits(quick), level + fine_.target(), share);
    return {gap.lower - fine_.target(), gap.upper - fine_.target(), !gap.depth_known};
}

Start Question::start() const
{
    const Over at_0 = over(0, 0);
    Start out;
    out.contact = at_0.upper <= 0;
    out.gap = at_0.upper;
    const Hundred slack = doubt * fine_.scale();
    out.deep = at_0.deep;
    out.in_doubt = !out.deep && at_0.lower <= slack && at_0.upper >= -slack;
    return out;
}

/// By looks at long double's gap, which finds no excursion between two of them; the end is halved in digits.
Leaving Question::leaving() const
{
    Leaving out;
    const long double target = coarse_.target();
    const long double t_max = t_max_;
    long double t = 0;
    long double before = 0;
    Bracket<long double> gap = coarse_.at(0);
    long double highest = gap.upper;
    do { // at the start there is contact, though long double may not see it
        if (t >= t_max) return out;
        const long double by_speed = coarse_.fastest() > 0 ? (target - gap.upper) / coarse_.fastest() : t_max;
        before = t;
        const long double least = std::clamp(t / 8, 1e-9L, 1e-5L); // contact may be left for a moment only
        t = std::min(t_max, t + std::max(std::min(by_speed, 0.01L), least));
        const bool depth_known = gap.depth_known;
        gap = coarse_.at(t, gap.normal);
        highest = std::max(highest, gap.upper);
        if (depth_known && gap.depth_known)
            out.drop = std::max(out.drop, static_cast<double>(highest - gap.upper));
        if (!gap.depth_known) highest = gap.upper;
    } while (gap.upper <= target + coarse_.blur());
    out.left = true;
    long double late = t;
    for (int i = 0; i < 60; ++i) { // as near as long double can tell
        const long double middle = (before + late) / 2;
        const Bracket<long double> there = coarse_.at(middle);
        const bool in_contact = there.upper + coarse_.blur() <= target;
        if (!in_contact && there.lower - coarse_.blur() <= target) break;
        (in_contact ? before : late) = middle;
    }
    out.by = crossing(fine_, before, late);
    return out;
}

bool Question::fine_walk(Stretch& out, const Hundred& to) const
{
    Limits<Hundred> limits{doubt * fine_.scale(), plain * fine_.scale(), budget_.fine - out.fine_evaluations};
    Walk<Hundred> w = walk(fine_, out.clear, to, limits);
    if (w.halt == Halt::far && w.clear == out.clear) { // where long double's time is too coarse
        limits.far = -1;
        w = walk(fine_, out.clear, to, limits);
    }
    out.clear = w.clear;
    out.fine_evaluations += w.evaluations;
    out.least = std::min(out.least, Hundred(w.least - fine_.target()));
    if (w.halt == Halt::far) return false;
    out.spent = w.halt == Halt::spent;
    if (w.touched) out.contact = w.touched;
    if (w.halt != Halt::near) return true;
    const std::optional<Hundred> soon = contact_after(fine_, w, to);
    if (soon) out.contact = soon;
    out.in_doubt = !soon;
    return true;
}

Stretch Question::clear(const Hundred& from, const Hundred& to) const
{
    Stretch out;
    out.clear = from;
    out.least = coarse_.at(static_cast<long double>(from)).upper - coarse_.target();
    const auto end = static_cast<long double>(to);
    const Limits<long double> limits{blurs * coarse_.blur(), -1, budget_.coarse};
    for (;;) {
        const auto begin = static_cast<long double>(out.clear);
        if (Hundred(begin) == out.clear) {
            Limits<long double> left = limits;
            left.budget -= out.evaluations;
            const Walk<long double> w = walk(coarse_, begin, end, left);
            out.clear = w.clear;
            out.evaluations += w.evaluations;
            out.least = std::min(out.least, Hundred(w.least) - fine_.target());
            out.spent = w.halt == Halt::spent;
            if (w.halt == Halt::done || out.spent) {
                if (w.touched) out.contact = Hundred(*w.touched);
                return out;
            }
        }
        if (fine_walk(out, to)) return out;
    }
}

} // namespace brink::support
