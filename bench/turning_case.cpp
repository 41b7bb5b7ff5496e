// SPDX-License-Identifier: BSD-3-Clause
#include "turning_case.h"

#include <fcl.h>
#include <print.h>
#include <referee_question.h>
#include <referee_turning.h>
#include <stress_turning.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brink::bench {
namespace {

using support::Hundred;
using support::Meeting;
using support::Query;
using support::Question;

constexpr double epsilon = 0x1p-52;
constexpr double fcl_nearness = 1e-4; // of the scale: a gap at which FCL may say contact, as is its default
constexpr double widest_turn = 3.1;   // radians, as FclProcess asks: FCL loses turns beyond pi

struct Asked {
    std::uint64_t index = 0;
    Spot spot;
    Query query;
    Toi toi;
    bool by_fcl = false;
    support::Testimony fcl;
};

/// What is so about a query, and the means to ask for the gap at any time.
struct Known {
    explicit Known(const Query& q) : meeting(support::meeting(q)), question(q) {}
    Meeting meeting;
    Question question;
};

/// FCL knows of no gap to be kept.
bool for_fcl(const Query& q)
{
    return q.options.target_gap == 0 && q.motion_a.rotation.norm() < widest_turn &&
           q.motion_b.rotation.norm() < widest_turn &&
           fcl_trusts(support::FclQuestion::conservative_advancement, q.a, q.b);
}

std::vector<Asked> ask(const Block& block, support::FclProcess& fcl)
{
    const support::TurningClass& kind = support::turning_classes[block.spot.kind];
    std::vector<Asked> cases;
    std::vector<support::Hearing> hearings;
    for (std::uint64_t i = block.begin; i < block.end; ++i) {
        support::StressCase drawn = stress(block.pair, kind.stress, block.seed, i);
        Spot spot = block.spot;
        spot.step = static_cast<std::size_t>((drawn.level - kind.first) / kind.decades);
        Asked asked{i, spot, std::move(drawn.query), {}, false, {}};
        asked.toi = answer(asked.query);
        asked.by_fcl = for_fcl(asked.query);
        if (asked.by_fcl) hearings.push_back({asked.query, {}, 0});
        cases.push_back(std::move(asked));
    }
    const std::vector<support::Testimony> testimonies = fcl.hear(hearings);
    auto next = testimonies.begin();
    for (Asked& asked : cases)
        if (asked.by_fcl) asked.fcl = *next++;
    return cases;
}

/// What design promise 3 allows gap(t) - target_gap to be.
Hundred allowed(const Query& q, const Question& question, double t)
{
    const support::MovingPair<Hundred>& fine = question.fine();
    const Hundred rounding = 16 * Hundred(epsilon) * fine.scale();
    const support::Pair pair{std::min(q.a.index(), q.b.index()), std::max(q.a.index(), q.b.index())};
    const bool closed = pair.closed_form() && !fine.turns();
    const Hundred band = closed ? rounding : std::max(rounding, Hundred(q.options.tolerance));
    const support::MovingPair<long double>& coarse = question.coarse();
    const long double speed = closing_speed(coarse, static_cast<long double>(t), coarse.at(t));
    return band + Hundred(std::max(speed, 0.0L)) * (std::nextafter(t, infinity) - t);
}

/// In digits: bounds in long double may lie as far apart as promise 3 allows.
Hundred gap_over_target(const Question& question, double t)
{
    return question.fine().at(t).upper - question.fine().target();
}

void measure_error(Score& score, const Query& q, const Known& known, double t)
{
    const Hundred& exact = known.meeting.by;
    const auto near = static_cast<double>(exact);
    const Hundred off = abs(exact - t);
    score.steps.push_back(static_cast<double>(off));
    score.ulps.push_back(static_cast<double>(off) / (std::nextafter(near, infinity) - near));
    const Hundred share = gap_over_target(known.question, t) / allowed(q, known.question, t);
    score.used.push_back(std::max(0.0, static_cast<double>(share)));
}

/// What both solvers are judged by. `near`: the gap at which contact may be said. Gives whether the decision
/// was wrong.
bool judge(Score& score, const Asked& asked, const Known& known, const std::optional<double>& t,
           const Hundred& near)
{
    const Meeting& m = known.meeting;
    const bool decided = m.meets || !t || gap_over_target(known.question, *t) > near;
    const bool wrong = decided && !m.in_doubt && t.has_value() != m.meets;
    score.meets += m.meets ? 1U : 0U;
    score.wrong += wrong ? 1U : 0U;
    score.late += t && m.meets && Hundred(*t) > m.by ? 1U : 0U;
    if (t && m.meets && !m.started && m.by > 0) measure_error(score, asked.query, known, *t);
    return wrong;
}

/// brink's answer; what is wrong with it is kept as a test.
void judge_brink(Scores& scores, const Asked& asked, const Known& known)
{
    Score& score = scores.score(asked.spot, Solver::brink);
    const Toi& toi = asked.toi;
    const support::Ruling ruling = rule(asked.query, toi);
    std::string what;
    for (const support::Finding& f : ruling.findings)
        what += fmt::format("{}: {}; ", f.check, f.detail);
    score.broken += what.empty() ? 0U : 1U;
    const bool unsettled = known.meeting.spent || ruling.unsettled;
    score.unsettled += unsettled ? 1U : 0U;
    const bool neither = toi.status == Status::undecided || toi.status == Status::invalid;
    score.undecided += neither ? 1U : 0U;
    score.conservative += toi.status == Status::hit && toi.t_upper == infinity ? 1U : 0U;
    bool wrong = false;
    if (!unsettled && neither && !grazes(asked.query, known.meeting, toi.t)) {
        ++score.stuck;
        what += "undecided where nothing grazes; ";
    }
    if (!unsettled && neither) score.meets += known.meeting.meets ? 1U : 0U;
    if (!unsettled && !neither) {
        const bool hit = toi.status != Status::separated;
        const std::optional<double> t = hit ? std::optional(toi.t) : std::nullopt;
        wrong = judge(score, asked, known, t, hit ? allowed(asked.query, known.question, toi.t) : Hundred(0));
    }
    if (wrong && what.empty()) what = "wrong decision; ";
    if (what.empty()) return;
    scores.complain({asked.spot, asked.index, wrong, as_cpp(asked.query, what + support::in_words(toi))});
}

void judge_fcl(Scores& scores, const Asked& asked, const Known& known)
{
    Score& score = scores.score(asked.spot, Solver::fcl);
    ++score.cases;
    if (known.meeting.spent) {
        ++score.unsettled;
        return;
    }
    if (asked.fcl.ending != support::Ending::answered) { // on a busy machine that is not FCL's fault alone
        ++score.undecided;
        return;
    }
    std::optional<double> t = asked.fcl.advancement;
    if (t && !(*t >= 0 && *t <= 1)) t.reset();
    judge(score, asked, known, t, fcl_nearness * known.question.fine().scale());
}

} // namespace

Scores measure_turning(const Block& block, support::FclProcess& fcl)
{
    Scores scores;
    for (const Asked& asked : ask(block, fcl)) {
        if (!judgeable(asked.query)) continue;
        const Known known(asked.query);
        ++scores.score(asked.spot, Solver::brink).cases;
        judge_brink(scores, asked, known);
        if (asked.by_fcl) judge_fcl(scores, asked, known);
    }
    return scores;
}

} // namespace brink::bench
