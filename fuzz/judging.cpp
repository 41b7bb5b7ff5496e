// SPDX-License-Identifier: BSD-3-Clause
#include "judging.h"

#include "in_digits.h"
#include "print.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace brink::fuzz {
namespace {

using support::Findings;
using support::Trial;

bool suspicious(const Case& c, bool acquitted)
{
    const Toi& toi = c.trial.toi();
    const bool answered = toi.status != Status::undecided && toi.status != Status::invalid;
    return !answered || (!acquitted && toi.iterations > 64);
}

void complain(Tally& tally, const Case& c, const Findings& findings)
{
    for (const support::Finding& f : findings) {
        const support::Query& asked = f.asked ? *f.asked : c.trial.query();
        const std::string note =
            f.asked ? "as asked otherwise: " + f.detail : support::in_words(c.trial.toi());
        tally.add(Complaint{c.index, f.check, f.detail, asked, note});
    }
}

/// By the reference, which knows no depth of a cylinder, cone, ellipsoid or hull.
Findings by_reference(Tally& tally, Trial& trial)
{
    ++tally.referenced;
    Findings findings = judge_by_reference(trial);
    if (trial.referee().gave_up) ++tally.given_up;
    return findings;
}

/// In doubles, of every case. Whether it acquits.
bool by_doubles(Tally& tally, Trial& trial)
{
    const support::Acquittal said = trial.quick().acquittal;
    ++tally.quick;
    if (said == support::Acquittal::strict) ++tally.strict;
    if (said == support::Acquittal::none) ++tally.unproven;
    return said != support::Acquittal::none;
}

Findings by_referee(Tally& tally, const Trial& trial, Patience patience)
{
    const Ruled ruled = fuzz::ruled(trial.query(), trial.toi(), patience);
    ++tally.ruled;
    if (ruled.in_digits) ++tally.in_digits;
    if (ruled.unsettled) ++tally.unsettled;
    return ruled.findings;
}

/// The contact in digits, once: how early the answer is, and whether `undecided` is excused.
Findings by_digits(Tally& tally, Case& c)
{
    if (c.sworn || !can_judge(c.trial.query())) return {};
    c.sworn = true;
    const support::Query& q = c.trial.query();
    const Toi& toi = c.trial.toi();
    const FirstContact contact = first_contact(q, toi);
    Findings findings = verified(q, toi);
    ++tally.sworn;
    if (contact.spent) ++tally.unsettled;
    if (contact.in_doubt) ++tally.in_doubt;
    if (toi.status == Status::undecided && contact.grazes) ++tally.excused;
    if (toi.status == Status::undecided && !contact.grazes && !contact.spent)
        findings.push_back(
            {std::string(guilty), fmt::format("least gap - target {:.3g}, closing {:.3g} per step",
                                              contact.least_gap, contact.closing_speed)});
    const bool timed = toi.status == Status::hit && contact.meets && !contact.in_doubt && !contact.grazes;
    if (timed) tally.add_early(q.options.tolerance, contact.early);
    return findings;
}

void count(Tally& tally, const Toi& toi)
{
    ++tally.cases;
    ++tally.by_status[std::min<std::size_t>(static_cast<std::size_t>(toi.status), 4)];
    const auto spent = static_cast<std::uint64_t>(std::max(toi.iterations, 0));
    tally.evaluations += spent;
    if (toi.status != Status::hit || spent == 0) return;
    ++tally.advanced_hits;
    tally.hit_evaluations += spent;
    tally.most_evaluations = std::max(tally.most_evaluations, spent);
}

/// All but the witnesses, who are asked about many at a time. Whether the answer is odd.
bool try_one(Tally& tally, const Pair& pair, Case& c)
{
    const Summons& summons = c.summons;
    const support::Query& q = c.trial.query();
    count(tally, c.trial.toi());
    if (!summons.valid && c.trial.toi().status == Status::invalid) return false;
    Findings findings = judge_form(c.trial);
    const bool form = findings.empty() && c.trial.toi().status != Status::invalid;
    const bool known = form && can_judge(q);
    const bool acquitted = known && by_doubles(tally, c.trial);
    if (form && (summons.otherwise || suspicious(c, acquitted))) {
        ++tally.asked;
        append(findings, judge_otherwise(c.trial));
    }
    const bool odd = suspicious(c, acquitted) || !findings.empty();
    if (pair.has_reference() && summons.reference_knows && (odd || summons.reference))
        append(findings, by_reference(tally, c.trial));
    const Patience patience = odd || summons.referee ? Patience::all : Patience::little;
    if (can_judge(q) && (patience == Patience::all || !acquitted))
        append(findings, by_referee(tally, c.trial, patience));
    const bool undecided = c.trial.toi().status == Status::undecided;
    if (!findings.empty() || undecided || summons.digits) append(findings, by_digits(tally, c));
    complain(tally, c, findings);
    return odd;
}

} // namespace

void append(Findings& all, Findings more)
{
    all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::string in_words(const support::Quick& quick)
{
    constexpr std::array<const char*, 7> doubts{"nothing",
                                                "the form",
                                                "the start",
                                                "apart before t",
                                                "contact at t",
                                                "t_upper",
                                                "gap, normal and points"};
    if (quick.acquittal == support::Acquittal::strict) return "acquitted";
    if (quick.acquittal == support::Acquittal::to_rounding) return "acquitted but for rounding";
    return fmt::format("in doubt about {}", doubts[static_cast<std::size_t>(quick.doubt)]);
}

Tally tried(const Pair& pair, std::vector<Case> cases, Witnesses& witnesses)
{
    Tally tally;
    std::vector<Case> to_witness;
    for (Case& c : cases) {
        const bool odd = try_one(tally, pair, c);
        const bool known = c.summons.valid || c.trial.toi().status != Status::invalid;
        const bool asked = known && (odd || c.summons.witnesses);
        if (asked && !pair.unbounded() && Witnesses::present()) to_witness.push_back(std::move(c));
    }
    const std::vector<Statement> statements = witnesses.question(to_witness);
    for (std::size_t i = 0; i < statements.size(); ++i) {
        ++tally.witnessed;
        tally.crashes += statements[i].crashed ? 1U : 0U;
        tally.hangs += statements[i].hung ? 1U : 0U;
        for (const Fault& fault : statements[i].against_them)
            tally.add(fault);
        Findings findings = statements[i].against_brink;
        if (!findings.empty()) append(findings, by_digits(tally, to_witness[i]));
        complain(tally, to_witness[i], findings);
    }
    return tally;
}

} // namespace brink::fuzz
