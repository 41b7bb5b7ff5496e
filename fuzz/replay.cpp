// SPDX-License-Identifier: BSD-3-Clause
#include "replay.h"

#include "in_digits.h"
#include "judging.h"
#include "progress.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <thread>

namespace brink::fuzz {
namespace {

using support::KeptQuery;
using Queries = std::vector<const KeptQuery*>;

constexpr std::size_t block_size = 32; // of one pair

/// The place of a query's pair in all_pairs().
std::size_t place(const std::vector<Pair>& all, const support::Query& q)
{
    const auto [first, second] = std::minmax({q.a.index(), q.b.index()});
    const auto found = std::find_if(all.begin(), all.end(), [low = first, high = second](const Pair& p) {
        return p.first == low && p.second == high;
    });
    return static_cast<std::size_t>(found - all.begin());
}

struct Job {
    std::size_t pair; // of all_pairs()
    Queries queries;
};

std::vector<Job> jobs_of(std::span<const KeptQuery> queries, const std::vector<Pair>& all)
{
    std::map<std::size_t, Queries> by_pair;
    for (const KeptQuery& kept : queries)
        by_pair[place(all, kept.query)].push_back(&kept);
    std::vector<Job> jobs;
    for (const auto& [pair, of_pair] : by_pair)
        for (std::size_t i = 0; i < of_pair.size(); i += block_size) {
            const auto begin = of_pair.begin() + static_cast<std::ptrdiff_t>(i);
            const auto size = static_cast<std::ptrdiff_t>(std::min(block_size, of_pair.size() - i));
            jobs.push_back({pair, Queries(begin, begin + size)});
        }
    return jobs;
}

std::vector<Case> cases_of(const Job& job)
{
    std::vector<Case> cases;
    for (const KeptQuery* kept : job.queries) {
        Summons everybody;
        everybody.valid = can_judge(kept->query);
        cases.push_back({kept->line, support::Trial(kept->query), everybody});
    }
    return cases;
}

/// The jobs, handed out one by one, and what came of them.
class Docket {
public:
    explicit Docket(std::span<const KeptQuery> queries) : jobs_(jobs_of(queries, all_)) {}

    void work_until_done()
    {
        Witnesses witnesses;
        for (std::size_t i = next_++; i < jobs_.size() && !Progress::stopped(); i = next_++) {
            const Job& job = jobs_[i];
            const Tally tally = tried(all_[job.pair], cases_of(job), witnesses);
            const std::scoped_lock lock(mutex_);
            tallies_[job.pair].add(tally);
            done_ += tally.cases;
            findings_ += tally.brink_findings();
        }
        forget_digits();
    }

    std::uint64_t done() const { return done_; }
    std::uint64_t findings() const { return findings_; }

    Replayed outcome() const
    {
        Replayed out;
        for (const auto& [pair, tally] : tallies_) {
            out.pairs.push_back(all_[pair]);
            out.tallies.push_back(tally);
        }
        return out;
    }

private:
    std::vector<Pair> all_ = support::all_pairs();
    std::vector<Job> jobs_;
    std::map<std::size_t, Tally> tallies_;
    std::mutex mutex_;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<std::uint64_t> done_ = 0, findings_ = 0;
};

} // namespace

Replayed replay(std::span<const KeptQuery> queries, int threads)
{
    Docket docket(queries);
    Progress progress(queries.size());
    std::atomic<int> working = threads;
    std::vector<std::thread> workers;
    for (int i = 0; i < threads; ++i)
        workers.emplace_back([&] {
            docket.work_until_done();
            --working;
        });
    while (working > 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        progress.tell(docket.done(), docket.findings());
    }
    for (std::thread& worker : workers)
        worker.join();
    progress.finish(docket.done(), docket.findings());
    Replayed out = docket.outcome();
    out.stopped = docket.done() < queries.size();
    return out;
}

} // namespace brink::fuzz
