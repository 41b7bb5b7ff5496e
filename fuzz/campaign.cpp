// SPDX-License-Identifier: BSD-3-Clause
#include "campaign.h"

#include "in_digits.h"
#include "judging.h"
#include "print.h"
#include "progress.h"
#include "witnesses.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <mutex>
#include <thread>

namespace brink::fuzz {
namespace {

using support::Findings;
using support::Trial;

constexpr std::uint64_t block_size = 256;

/// Half of the cases are for breadth, half for what turns; whichever cases are picked by a stride.
bool for_breadth(std::uint64_t index) { return std::popcount(index) % 2 == 0; }

support::Query drawn(const Pair& pair, std::uint64_t seed, std::uint64_t index)
{
    return for_breadth(index) ? query(pair, support::Family::any, seed, index, support::Aim::quick)
                              : campaign_query(pair, seed, index, support::Aim::quick);
}

/// A block of one pair's cases.
Tally work(const Plan& plan, const Pair& pair, std::uint64_t begin, std::uint64_t end, Witnesses& witnesses)
{
    std::vector<Case> cases;
    for (std::uint64_t i = begin; i < end; ++i) {
        Summons summons{for_breadth(i), i % plan.reference_every == 0, i % plan.rule_every == 0,
                        i % plan.digits_every == 0, i % plan.witness_every == 0};
        summons.otherwise = i % plan.ask_every == 0;
        cases.push_back({i, Trial(drawn(pair, plan.seed, i)), summons});
    }
    return tried(pair, std::move(cases), witnesses);
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
    std::vector<Case> one{{index, Trial(drawn(pair, seed, index)), {}}};
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
    if (can_judge(trial.query())) {
        const support::Quick& quick = trial.quick();
        out += fmt::format("in doubles: {} of {} looks\n", in_words(quick), quick.looks);
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
