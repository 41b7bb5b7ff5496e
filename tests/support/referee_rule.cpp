// SPDX-License-Identifier: BSD-3-Clause
#include "referee_question.h"
#include "referee_turning.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brink::support {
namespace {

constexpr double eps = 0x1p-52;

double shown(const Hundred& x) { return static_cast<double>(x); }

/// From |x| to the next double.
double ulp(double x) { return std::nextafter(std::abs(x), infinity) - std::abs(x); }

struct Case {
    const Query& q;
    const Toi& toi;
    Question question;
    Start start;
    Hundred rounding; // 16 eps S
    Hundred band;     // what promise 3 allows gap(t) - target_gap to be, but for the last bit of t

    Case(const Query& query, const Toi& answer, const Budget& budget)
        : q(query), toi(answer), question(query, budget), start(question.start())
    {
        const MovingPair<Hundred>& pair = question.fine();
        rounding = 16 * Hundred(eps) * pair.scale();
        const Pair shapes{std::min(q.a.index(), q.b.index()), std::max(q.a.index(), q.b.index())};
        const bool closed = shapes.closed_form() && !pair.turns();
        band = closed ? rounding : std::max(rounding, Hundred(q.options.tolerance));
    }

    /// Rounding decides whether the pair starts in contact. Asked of either limit, as bounds that tell on
    /// which side of the target the gap is may lie far from it.
    bool start_near() const
    {
        return !start.deep && least_start_gap() <= rounding && question.over(0, -rounding).upper > -rounding;
    }
    /// gap(0) - target_gap from below, above `rounding` if that is.
    Hundred least_start_gap() const { return question.over(0, rounding).lower; }
    bool answered() const { return toi.status == Status::hit || toi.status == Status::touching; }
};

/// Promises 1 and 2: no contact in question in [from, t).
void judge_apart(const Case& c, const Hundred& from, Ruling& out)
{
    const bool separated = c.toi.status == Status::separated;
    const Hundred to = separated ? c.q.options.t_max : c.toi.t;
    if (to <= from) return;
    const Stretch s = c.question.clear(from, to);
    out.in_digits = out.in_digits || s.fine_evaluations > 0;
    out.unsettled = s.spent;
    if (!s.contact || (!separated && *s.contact >= to)) return;
    if (separated && s.in_doubt && *s.contact >= to) return;
    out.findings.push_back(
        {separated ? "missed a hit" : "late",
         fmt::format(
             "contact by {:.17g}, which is {:.3g} before t = {:.17g}; the gap falls {:.3g} below the target",
             shown(*s.contact), shown(to - *s.contact), c.toi.t, shown(-s.least))});
}

/// Promise 3, of a hit.
void judge_tight(const Case& c, const Hundred& from, Ruling& out)
{
    const Toi& toi = c.toi;
    const Question::Over now = c.question.over(toi.t, c.band);
    if (now.lower > c.band) {
        const MovingPair<long double>& pair = c.question.coarse();
        const auto speed = closing_speed(pair, static_cast<long double>(toi.t), pair.at(toi.t));
        const Hundred most = c.band + Hundred(std::max(speed, 0.0L)) * ulp(toi.t) * 1.001;
        if (now.lower > most)
            out.findings.push_back({"early", fmt::format("gap - target = {:.3g} at t, allowed {:.3g}",
                                                         shown(now.lower), shown(most))});
    }
    if (!(toi.t <= toi.t_upper)) out.findings.push_back({"t_upper", "t_upper before t"});
    if (!(toi.t_upper < infinity) || !out.findings.empty()) return;
    if (toi.t_upper > 1 || c.question.over(toi.t_upper, 0).upper <= 0) return;
    const Stretch s = c.question.clear(std::max(from, Hundred(toi.t)), toi.t_upper);
    if (s.contact || s.spent || s.in_doubt) return;
    out.findings.push_back(
        {"t_upper", fmt::format("no contact by {:.17g}, where the gap is {:.3g} above the target",
                                toi.t_upper, shown(c.question.over(toi.t_upper, 0).lower))});
}

/// Promise 5: a pair that is not in contact, recedes and never meets is separated.
void judge_sticking(const Case& c, Ruling& out)
{
    if (c.toi.status != Status::hit || c.toi.t != 0 || c.start.contact || c.start.in_doubt) return;
    const MovingPair<long double>& pair = c.question.coarse();
    const Bracket<long double> here = pair.at(0);
    constexpr long double soon = 1e-6L;
    const long double climb =
        pair.at(std::min(soon, static_cast<long double>(c.q.options.t_max))).lower - here.upper;
    if (closing_speed(pair, 0.0L, here) >= 0 || climb <= static_cast<long double>(c.rounding)) return;
    if (c.question.clear(0, c.q.options.t_max).contact) return;
    out.findings.push_back({"sticks", "hit at 0 for a pair that is apart and recedes"});
}

/// Promise 5.
void judge_start(const Case& c, Ruling& out)
{
    const bool touching = c.toi.status == Status::touching;
    if (touching && c.toi.t != 0) out.findings.push_back({"t", "touching, but t is not 0"});
    if (touching && !c.start.contact && !c.start_near())
        out.findings.push_back(
            {"touching", fmt::format("gap(0) is {:.3g} above the target", shown(c.least_start_gap()))});
    const StartContact option = c.q.options.start_contact;
    const bool reported = c.start.contact && option == StartContact::report;
    const bool late = c.toi.status == Status::separated || c.toi.t > 0;
    if (!touching && reported && (late || !c.start_near()))
        out.findings.push_back({"touching", fmt::format("not said, but gap(0) is {:.3g} below the target",
                                                        shown(-c.start.gap))});
    if (touching && option == StartContact::ignore)
        out.findings.push_back({"start contact", "touching, though contact at the start is to be ignored"});
}

/// Contact at the start that was ignored.
void judge_ignored(const Case& c, Ruling& out)
{
    if (c.toi.status == Status::touching) return;
    const Leaving leaving = c.question.leaving();
    const bool proven = c.q.options.start_contact == StartContact::ignore_if_separating;
    if (proven && leaving.drop > shown(c.rounding))
        out.findings.push_back(
            {"start contact", fmt::format("not touching, but the gap falls by {:.3g}", leaving.drop)});
    if (!leaving.left && c.toi.status == Status::hit)
        out.findings.push_back({"start contact", "hit, but the gap never exceeds the target"});
    if (!leaving.left) return;
    judge_apart(c, leaving.by, out);
    if (c.toi.status == Status::hit && c.toi.t > leaving.by) judge_tight(c, leaving.by, out);
}

void judge_from_apart(const Case& c, Ruling& out)
{
    judge_apart(c, 0, out);
    if (c.toi.status == Status::hit) judge_tight(c, 0, out);
    judge_sticking(c, out);
}

/// Where rounding decides whether there is contact to be ignored, either reading may be the answer's.
void judge_times(const Case& c, Ruling& out)
{
    const bool ignores = c.q.options.start_contact != StartContact::report;
    if (!ignores && (c.start.contact || c.start.in_doubt)) return;
    const bool either = ignores && (c.start.in_doubt || c.start_near());
    if (either || !c.start.contact) {
        Ruling as_apart = out;
        judge_from_apart(c, as_apart);
        const bool content = as_apart.findings.size() == out.findings.size();
        if (!either || content) out = as_apart;
        if (!either || content) return;
    }
    judge_ignored(c, out);
}

} // namespace

Ruling rule(const Query& q, const Toi& toi, const Budget& budget)
{
    Ruling out;
    if (!(toi.t >= 0 && toi.t <= q.options.t_max))
        out.findings.push_back({"t", fmt::format("{:.17g}", toi.t)});
    if (toi.status == Status::separated && toi.t != q.options.t_max)
        out.findings.push_back({"t", "separated, but t is not t_max"});
    if (toi.status == Status::invalid) out.findings.push_back({"invalid", "of a valid query"});
    if (!out.findings.empty()) return out;
    const Case c(q, toi, budget);
    if (!c.start.in_doubt) judge_start(c, out);
    judge_times(c, out);
    if (c.answered() && q.options.detail == Detail::contact) {
        const Findings more = judge_contact(q, toi, c.question);
        out.findings.insert(out.findings.end(), more.begin(), more.end());
    }
    return out;
}

} // namespace brink::support
