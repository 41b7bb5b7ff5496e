// SPDX-License-Identifier: BSD-3-Clause
#include "stability_case.h"

#include <fcl.h>
#include <print.h>
#include <referee.h>
#include <stress.h>
#include <textbook.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brink::bench {
namespace {

using support::Digits;
using support::Query;
using support::Truth;

constexpr double epsilon = 0x1p-52;

/// One case and what everybody said: a time of contact, or none.
struct Asked {
    std::uint64_t index = 0;
    std::size_t step = 0;
    Query query;
    Toi toi;
    std::array<std::optional<double>, solver_names.size()> said{};
    bool by_fcl = false;

    std::optional<double>& said_by(Solver s) { return said[static_cast<std::size_t>(s)]; }
    const std::optional<double>& said_by(Solver s) const { return said[static_cast<std::size_t>(s)]; }
};

Asked ask(const Block& block, std::uint64_t index)
{
    const support::StressClass& kind = support::stress_classes[block.spot.kind];
    support::StressCase drawn = stress(block.pair, kind.stress, block.seed, index);
    Asked asked{index,
                static_cast<std::size_t>((drawn.level - kind.first) / kind.decades),
                std::move(drawn.query),
                {}};
    const Query& q = asked.query;
    asked.toi = answer(q);
    if (asked.toi.status == Status::hit || asked.toi.status == Status::touching)
        asked.said_by(Solver::brink) = asked.toi.t;
    asked.said_by(Solver::textbook) = textbook_toi(q, support::Root::textbook);
    asked.said_by(Solver::stable) = textbook_toi(q, support::Root::stable);
    return asked;
}

/// FCL knows of no gap to be kept, and of no end but that of the step.
bool for_fcl(const Asked& asked)
{
    const Query& q = asked.query;
    return asked.index % fcl_every == 0 && q.options.target_gap == 0 &&
           fcl_trusts(support::FclQuestion::conservative_advancement, q.a, q.b);
}

void ask_fcl(std::vector<Asked>& cases, support::FclProcess& fcl)
{
    std::vector<support::Hearing> hearings;
    for (Asked& asked : cases) {
        asked.by_fcl = for_fcl(asked);
        if (asked.by_fcl) hearings.push_back({asked.query, {}, 0});
    }
    const std::vector<support::Testimony> testimonies = fcl.hear(hearings);
    auto next = testimonies.begin();
    for (Asked& asked : cases) {
        if (!asked.by_fcl) continue;
        const std::optional<double> t = (next++)->advancement;
        if (t && *t <= asked.query.options.t_max) asked.said_by(Solver::fcl) = t;
    }
}

double distance_and_radii(const Query& q)
{
    const double apart = (q.motion_a.start.position - q.motion_b.start.position).stableNorm();
    return apart + std::get<Sphere>(q.a).radius + std::get<Sphere>(q.b).radius + q.options.target_gap;
}

/// How far t is off, forwards and backwards.
void measure_error(Score& score, const Query& q, const Truth& truth, double t)
{
    score.ulps.push_back(support::ulp_error(truth.t, t));
    const Digits gap = abs(gap_minus_target(q, t));
    score.backward = std::max(score.backward, static_cast<double>(Digits(gap / (epsilon * truth.scale))));
    if (!std::holds_alternative<Sphere>(q.a) || !std::holds_alternative<Sphere>(q.b)) return;
    const Digits centres = epsilon * Digits(distance_and_radii(q));
    score.backward_centres = std::max(score.backward_centres, static_cast<double>(Digits(gap / centres)));
}

bool is_late(const Truth& truth, double t) { return truth.t >= 0 && Digits(t) > truth.t + truth.blur; }

void judge_brink(Score& score, const Toi& toi)
{
    score.undecided += toi.status == Status::undecided || toi.status == Status::invalid ? 1U : 0U;
    if (toi.status != Status::hit) return;
    score.conservative += toi.t_upper == infinity ? 1U : 0U;
    if (toi.t_upper == infinity) return;
    const double ulp = std::nextafter(toi.t, infinity) - toi.t;
    score.bracket = std::max(score.bracket, (toi.t_upper - toi.t) / ulp);
}

/// What is wrong with brink's answer, as a test; empty when nothing is.
std::string objection(const Asked& asked, bool wrong, bool late)
{
    std::string what;
    for (const support::Finding& f : verify(asked.query, asked.toi))
        what += fmt::format("{}: {}; ", f.check, f.detail);
    if (what.empty() && wrong) what = "wrong decision; ";
    if (what.empty() && late) what = "late; ";
    return what.empty() ? what : as_cpp(asked.query, what + support::in_words(asked.toi));
}

void judge(Scores& scores, const Asked& asked, Spot spot)
{
    spot.step = asked.step;
    const Query& q = asked.query;
    if (!refereed(q)) return;
    const Truth truth = support::truth(q);
    const bool undecided = asked.toi.status == Status::undecided || asked.toi.status == Status::invalid;
    const bool agreed = truth.meets && !truth.in_doubt && truth.t > 0 && asked.said_by(Solver::brink) &&
                        asked.said_by(Solver::textbook) && asked.said_by(Solver::stable);
    for (const Solver solver : {Solver::brink, Solver::textbook, Solver::stable, Solver::fcl}) {
        if (solver == Solver::fcl && !asked.by_fcl) continue;
        Score& score = scores.score(spot, solver);
        const std::optional<double>& t = asked.said_by(solver);
        const bool decided = solver != Solver::brink || !undecided;
        const bool wrong = decided && !truth.in_doubt && t.has_value() != truth.meets;
        const bool late = t && is_late(truth, *t);
        ++score.cases;
        score.meets += truth.meets ? 1U : 0U;
        score.wrong += wrong ? 1U : 0U;
        score.late += late ? 1U : 0U;
        if (agreed && t) measure_error(score, q, truth, *t);
        if (solver != Solver::brink) continue;
        judge_brink(score, asked.toi);
        const std::string text = objection(asked, wrong, late);
        score.broken += text.empty() ? 0U : 1U;
        if (!text.empty()) scores.complain({spot, asked.index, wrong, text});
    }
}

} // namespace

Scores measure(const Block& block, support::FclProcess& fcl)
{
    std::vector<Asked> cases;
    for (std::uint64_t i = block.begin; i < block.end; ++i)
        cases.push_back(ask(block, i));
    ask_fcl(cases, fcl);
    Scores scores;
    for (const Asked& asked : cases)
        judge(scores, asked, block.spot);
    return scores;
}

} // namespace brink::bench
