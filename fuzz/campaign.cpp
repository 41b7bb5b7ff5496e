// SPDX-License-Identifier: BSD-3-Clause
#include "campaign.h"

#include "in_digits.h"
#include "print.h"
#include "progress.h"
#include "witnesses.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <iterator>
#include <mutex>
#include <thread>

namespace brink::fuzz {
namespace {

using support::Findings;
using support::Trial;

constexpr std::uint64_t block_size = 256;

bool suspicious(const Toi& toi)
{
    return toi.status == Status::undecided || toi.status == Status::invalid || toi.iterations > 64;
}

/// Half of the cases are for breadth, half for what turns; whichever cases are picked by a stride.
bool for_breadth(std::uint64_t index) { return std::popcount(index) % 2 == 0; }

support::Query drawn(const Pair& pair, std::uint64_t seed, std::uint64_t index)
{
    return for_breadth(index) ? query(pair, support::Family::any, seed, index)
                              : campaign_query(pair, seed, index);
}

void complain(Tally& tally, const Case& c, const Findings& findings)
{
    for (const support::Finding& f : findings) {
        const support::Query& asked = f.asked ? *f.asked : c.trial.query();
        const std::string note =
            f.asked ? "as asked otherwise: " + f.detail : support::in_words(c.trial.toi());
        tally.add(Complaint{c.index, f.check, f.detail, support::as_cpp(asked, note)});
    }
}

void append(Findings& all, Findings more)
{
    all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// By the reference, which knows no depth of a cylinder, cone, ellipsoid or hull.
Findings by_reference(Tally& tally, Trial& trial)
{
    ++tally.referenced;
    Findings findings = judge_by_reference(trial);
    if (trial.referee().gave_up) ++tally.given_up;
    return findings;
}

Findings by_referee(Tally& tally, const Trial& trial)
{
    const Ruled ruled = fuzz::ruled(trial.query(), trial.toi());
    ++tally.ruled;
    if (ruled.in_digits) ++tally.in_digits;
    if (ruled.unsettled) ++tally.unsettled;
    return ruled.findings;
}

/// The contact in digits, once: how early the answer is, and whether `undecided` is excused.
Findings by_digits(Tally& tally, Case& c)
{
    if (c.sworn || !judgeable(c.trial.query())) return {};
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

/// A block of one pair's cases.
Tally work(const Plan& plan, const Pair& pair, std::uint64_t begin, std::uint64_t end, Witnesses& witnesses)
{
    Tally tally;
    std::vector<Case> to_witness;
    for (std::uint64_t i = begin; i < end; ++i) {
        Case c{i, Trial(drawn(pair, plan.seed, i))};
        count(tally, c.trial.toi());
        Findings findings = judge_alone(c.trial);
        const bool odd = suspicious(c.trial.toi()) || !findings.empty();
        if (pair.has_reference() && for_breadth(i) && (odd || i % plan.reference_every == 0))
            append(findings, by_reference(tally, c.trial));
        if (judgeable(c.trial.query()) && (odd || i % plan.rule_every == 0))
            append(findings, by_referee(tally, c.trial));
        const bool undecided = c.trial.toi().status == Status::undecided;
        if (!findings.empty() || undecided || i % plan.digits_every == 0)
            append(findings, by_digits(tally, c));
        complain(tally, c, findings);
        const bool asked = i % plan.witness_every == 0 || odd;
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

/// The blocks of a plan in order, pair after pair within a block of indices.
class Queue {
public:
    explicit Queue(const Plan& plan) : plan_(plan), tallies_(plan.pairs.size()) {}

    void work_until_done()
    {
        Witnesses witnesses;
        for (;;) {
            const std::uint64_t job = next_job_.fetch_add(1);
            const std::uint64_t pair = job % plan_.pairs.size();
            const std::uint64_t begin = job / plan_.pairs.size() * block_size;
            if (Progress::stopped() || begin >= plan_.cases) {
                const std::scoped_lock lock(mutex_);
                first_undone_ = std::min(first_undone_, std::min(begin, plan_.cases));
                return;
            }
            const std::uint64_t end = std::min(begin + block_size, plan_.cases);
            const Tally tally =
                work(plan_, plan_.pairs[pair], plan_.first + begin, plan_.first + end, witnesses);
            const std::scoped_lock lock(mutex_);
            tallies_[pair].add(tally);
            done_ += tally.cases;
            findings_ += tally.brink_findings();
        }
    }

    std::uint64_t done() const { return done_; }
    std::uint64_t findings() const { return findings_; }
    Outcome outcome(bool stopped) const
    {
        return {tallies_, stopped && first_undone_ < plan_.cases, plan_.first + first_undone_};
    }

private:
    const Plan& plan_;
    std::vector<Tally> tallies_;
    std::mutex mutex_;
    std::atomic<std::uint64_t> next_job_ = 0, done_ = 0, findings_ = 0;
    std::uint64_t first_undone_ = ~std::uint64_t{0};
};

} // namespace

Outcome run(const Plan& plan)
{
    Queue queue(plan);
    Progress progress(plan.cases * plan.pairs.size());
    std::atomic<int> working = plan.threads;
    std::vector<std::thread> threads;
    threads.reserve(static_cast<std::size_t>(plan.threads));
    for (int i = 0; i < plan.threads; ++i)
        threads.emplace_back([&] {
            queue.work_until_done();
            forget_digits();
            --working;
        });
    while (working > 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        progress.tell(queue.done(), queue.findings());
    }
    for (std::thread& thread : threads)
        thread.join();
    progress.finish(queue.done(), queue.findings());
    return queue.outcome(Progress::stopped());
}

std::string show(const Pair& pair, std::uint64_t seed, std::uint64_t index)
{
    std::vector<Case> one{{index, Trial(drawn(pair, seed, index))}};
    Trial& trial = one.front().trial;
    std::string out = support::as_cpp(trial.query(), support::in_words(trial.toi()));
    if (pair.unbounded()) return out;
    const support::Reference& ref = trial.referee();
    out += fmt::format(
        "reference: contact {} at {:.20Lg}, start gap {:.6Lg}, least gap {:.6Lg}, closing {:.6Lg} of {:.6Lg}"
        ", evaluations {}{}\n",
        ref.contact, ref.t, ref.start_gap, ref.least_gap, ref.closing_speed, trial.motion().fastest(),
        ref.evaluations, ref.gave_up ? ", gave up" : "");
    Findings findings = pair.has_reference() ? judge(trial) : judge_alone(trial);
    Witnesses witnesses;
    const Statement said = witnesses.question(one).front();
    append(findings, said.against_brink);
    if (judgeable(trial.query())) {
        out += truth_in_words(trial.query());
        append(findings, ruled(trial.query(), trial.toi()).findings);
        append(findings, verified(trial.query(), trial.toi()));
    }
    for (const support::Finding& f : findings)
        out += fmt::format("brink: {}: {}\n{}", f.check, f.detail, f.asked ? support::as_cpp(*f.asked) : "");
    for (const Fault& fault : said.against_them)
        out += fmt::format("{} {:.3g}\n", fault.cause, fault.size);
    if (said.crashed || said.hung) out += "FCL or libccd crashed or hung\n";
    return out;
}

} // namespace brink::fuzz
