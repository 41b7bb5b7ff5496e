// SPDX-License-Identifier: BSD-3-Clause
#include "witnesses.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#if BRINK_HAVE_FCL
#include "fcl_process.h"
#endif

namespace brink::fuzz {

using support::Real;

#if BRINK_HAVE_FCL

using support::Hearing;
using support::Reference;
using support::Testimony;
using support::Trial;

namespace {

/// Of the scale: FCL's distances are trusted to this (3e-7 was measured), its booleans where the gap is
/// larger.
constexpr Real trust = 1e-6L;

/// FCL's conservative advancement may find a contact this much of the step too late.
constexpr double fcl_late = 1e-3;

Hearing ask(const Case& c)
{
    Hearing out{c.trial.query(), {}, 0};
    const Toi& toi = c.trial.toi();
    for (int k = 0; k < 8; ++k)
        out.times[out.count++] = toi.t * k / 8;
    out.times[out.count++] = toi.t * (1 - 1e-9);
    out.times[out.count++] = toi.t;
    out.times[out.count++] = toi.t + 0.1 * (c.trial.query().options.t_max - toi.t);
    return out;
}

/// One judge's word about one time: a signed gap, of which a boolean is the sign.
void judge_overlap(Statement& out, Trial& trial, std::uint64_t index, const char* who, bool overlap,
                   Real truth)
{
    const Real doubt = trust * trial.motion().scale();
    if (overlap && truth > doubt)
        out.against_them.push_back(
            {fmt::format("{} says overlap, apart by", who), static_cast<double>(truth), index});
    if (!overlap && truth < -doubt)
        out.against_them.push_back(
            {fmt::format("{} says apart, deep by", who), static_cast<double>(-truth), index});
}

void judge_distance(Statement& out, Trial& trial, std::uint64_t index, double distance, Real truth)
{
    const Real doubt = trust * trial.motion().scale();
    const auto off = static_cast<double>(std::abs(distance - truth));
    if (truth > doubt && distance > 0 && static_cast<Real>(off) > doubt)
        out.against_them.push_back({"FCL distance off by", off, index});
    if (truth > doubt && distance <= 0)
        out.against_them.push_back(
            {"FCL distance says overlap, apart by", static_cast<double>(truth), index});
    if (truth < -doubt && distance > static_cast<double>(doubt))
        out.against_them.push_back({"FCL distance says apart, deep by", static_cast<double>(-truth), index});
}

void judge_time(Statement& out, Case& c, const Testimony::At& at, double t)
{
    Trial& trial = c.trial;
    const Real truth = trial.motion().at(t).gap;
    if (at.distance) judge_distance(out, trial, c.index, *at.distance, truth);
    if (at.collide) judge_overlap(out, trial, c.index, "FCL collide", *at.collide, truth);
    if (at.gjk) judge_overlap(out, trial, c.index, "libccd GJK", *at.gjk, truth);
    if (at.mpr) judge_overlap(out, trial, c.index, "libccd MPR", *at.mpr, truth);
    const Real target = trial.query().options.target_gap;
    const Real doubt = trust * trial.motion().scale();
    const bool near = (at.distance && *at.distance < static_cast<double>(target - doubt)) ||
                      (at.collide && *at.collide) || (at.gjk && *at.gjk);
    if (t >= trial.toi().t || !near || truth >= target - 2 * trial.rounding()) return;
    if (trial.referee().started || trial.start_in_doubt()) return;
    out.against_brink.push_back({"contact before t", fmt::format("FCL or libccd see it at {:.17g}", t)});
}

/// How deep the contact that FCL missed is seen to be.
Real depth_seen(Trial& trial)
{
    constexpr int looks = 16;
    const Real from = trial.toi().t, span = trial.query().options.t_max - from;
    Real least = std::numeric_limits<Real>::infinity();
    for (int i = 0; i <= looks; ++i)
        least = std::min(least, trial.motion().at(from + span * i / looks).gap);
    return static_cast<Real>(trial.query().options.target_gap) - least;
}

/// Of an answer that is acquitted, which is then what to judge FCL by. The dense reference may take longer
/// than thousands of cases. Whether there is no more to say.
bool judge_by_answer(Statement& out, Case& c, std::optional<double> when)
{
    Trial& trial = c.trial;
    const Toi& toi = trial.toi();
    if (trial.quick().acquittal == support::Acquittal::none) return false;
    if (toi.status == Status::separated) return !when;
    if (toi.status != Status::hit) return false;
    if (!when) {
        const Real depth = trial.query().options.target_gap == 0 ? depth_seen(trial) : 0;
        if (depth > trust * trial.motion().scale())
            out.against_them.push_back({"FCL CA missed a hit, deep by", static_cast<double>(depth), c.index});
        return true;
    }
    if (toi.t > *when + fcl_late) return false;
    const double late = *when - toi.t;
    const bool plain = trial.query().options.target_gap == 0 && *when <= trial.query().options.t_max;
    if (plain && late > fcl_late) out.against_them.push_back({"FCL CA late by", late, c.index});
    return true;
}

void judge_advancement(Statement& out, Case& c, std::optional<double> when)
{
    if (judge_by_answer(out, c, when)) return;
    Trial& trial = c.trial;
    const Toi& toi = trial.toi();
    const Reference& ref = trial.referee();
    const Options& options = trial.query().options;
    if (ref.started || ref.gave_up || trial.start_in_doubt()) return;
    const Real target = options.target_gap;
    const bool deep = ref.contact && ref.least_gap < target - trust * trial.motion().scale();
    if (!when) {
        const auto depth = static_cast<double>(target - ref.least_gap);
        if (deep && target == 0) out.against_them.push_back({"FCL CA missed a hit, deep by", depth, c.index});
        return;
    }
    if (*when > options.t_max) return;
    const bool found =
        toi.status == Status::touching || toi.status == Status::hit || toi.status == Status::undecided;
    if (found && toi.t <= *when + fcl_late) {
        const auto late = *when - static_cast<double>(ref.t);
        if (target == 0 && ref.contact && late > fcl_late)
            out.against_them.push_back({"FCL CA late by", late, c.index});
        return;
    }
    if (deep && ref.t <= *when + fcl_late)
        out.against_brink.push_back({"FCL CA hits first", fmt::format("at {:.17g}", *when)});
    else
        out.against_them.push_back({"FCL CA hits where the gap is still",
                                    static_cast<double>(trial.motion().at(*when).gap - target), c.index});
}

Statement judge(Case& c, const Hearing& hearing, const Testimony& testimony)
{
    Statement out;
    out.crashed = testimony.ending == support::Ending::crashed;
    out.hung = testimony.ending == support::Ending::hung;
    if (testimony.ending != support::Ending::answered) return out;
    for (std::size_t i = 0; i < hearing.count; ++i)
        judge_time(out, c, testimony.at[i], hearing.times[i]);
    if (testimony.asked_advancement) judge_advancement(out, c, testimony.advancement);
    return out;
}

} // namespace

struct Witnesses::Process {
    support::FclProcess fcl;
};

std::vector<Statement> Witnesses::question(std::span<Case> cases)
{
    std::vector<Hearing> hearings;
    for (const Case& c : cases)
        hearings.push_back(ask(c));
    const std::vector<Testimony> testimonies = process_->fcl.hear(hearings);
    std::vector<Statement> out;
    for (std::size_t i = 0; i < cases.size(); ++i)
        out.push_back(judge(cases[i], hearings[i], testimonies[i]));
    return out;
}

bool Witnesses::present() { return true; }

#else

struct Witnesses::Process {};

std::vector<Statement> Witnesses::question(std::span<Case> cases)
{
    return std::vector<Statement>(cases.size());
}

bool Witnesses::present() { return false; }

#endif

Witnesses::Witnesses() : process_(std::make_unique<Process>()) {}
Witnesses::~Witnesses() = default;

} // namespace brink::fuzz
