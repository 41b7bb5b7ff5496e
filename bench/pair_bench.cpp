// SPDX-License-Identifier: BSD-3-Clause
#include "pair_bench.h"

#include "machine.h"
#include "output.h"
#include "pair_sample.h"
#include "single_query.h"

#include <algorithm>
#include <array>
#include <benchmark/benchmark.h>
#include <fcl.h>
#include <fmt/format.h>

#include <map>
#include <memory>

namespace brink::bench {
namespace {

constexpr int still_repetitions = 15;
constexpr int turning_repetitions = 7;
constexpr std::size_t brink_queries = 120'000; // half of them hit
constexpr std::size_t fcl_queries = 4'096;
constexpr int quick_repetitions = 3;

/// What one benchmark asks, over and over: a list of pairs, as many as a repetition has iterations.
struct Job {
    Timing timing; // what is to be measured; the figures are filled in
    Turning turning;
    const Sample* sample;
    const std::vector<Pair>* pairs;
    bool fcl() const { return timing.who == "FCL"; }
    std::size_t queries() const { return static_cast<std::size_t>(timing.queries); }
};

Toi ask_brink(const Job& job, const Pair& pair, const Options& options)
{
    const Body& a = job.sample->bodies[pair.a];
    const Body& b = job.sample->bodies[pair.b];
    return time_of_impact(a.shape, a.motion, b.shape, b.motion, options);
}

std::optional<double> ask_fcl(const Job& job, const Pair& pair, const std::vector<support::FclBody>& fcl)
{
    const std::vector<Body>& bodies = job.sample->bodies;
    return fcl_continuous(support::FclQuestion::conservative_advancement, fcl[pair.a], bodies[pair.a].motion,
                          fcl[pair.b], bodies[pair.b].motion);
}

/// Distance evaluations of brink, and the queries it left undecided.
void count_calls(Job& job)
{
    Timing& timing = job.timing;
    std::int64_t calls = 0;
    for (const Pair& pair : *job.pairs) {
        const Toi toi = ask_brink(job, pair, {});
        calls += toi.iterations;
        timing.most_calls = std::max(timing.most_calls, toi.iterations);
        if (toi.status == Status::undecided) ++timing.undecided;
    }
    timing.calls = static_cast<double>(calls) / static_cast<double>(job.pairs->size());
}

/// Collects the means and deviations that Google Benchmark makes of the repetitions.
class Collector : public benchmark::BenchmarkReporter {
public:
    explicit Collector(std::vector<Job>& jobs) : jobs_(jobs) {}

    bool ReportContext(const Context&) override { return true; }

    void ReportRuns(const std::vector<Run>& runs) override
    {
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Aggregate) continue;
            Timing& timing = jobs_[std::stoul(run.run_name.function_name)].timing;
            if (run.aggregate_name == "mean") timing.ns = run.GetAdjustedCPUTime();
            if (run.aggregate_name == "stddev") timing.deviation = run.GetAdjustedCPUTime();
        }
    }

private:
    std::vector<Job>& jobs_;
};

/// Everything to be measured, and what it is measured on.
class Bench {
public:
    Bench(Rivals rivals, const std::vector<std::string>& names, Effort effort)
        : rivals_(rivals), effort_(effort)
    {
        const auto named = [&](const PairKind& kind) {
            return std::find(names.begin(), names.end(), kind.name) != names.end();
        };
        for (const Turning turning : every_turning)
            for (const PairKind& kind : pairs_turning(turning))
                if (named(kind)) add(kind, turning);
    }

    std::vector<Timing> run()
    {
        int steps = 0;
        for (const Job& job : jobs_)
            steps += job.timing.repetitions + 1;
        Progress progress(fmt::format("pairs, {}", build_name()), steps);
        measure_repetitions(progress);
        std::vector<Timing> timings;
        for (Job& job : jobs_) {
            if (job.turning != Turning::none) measure_singly(job);
            timings.push_back(job.timing);
            progress.step();
        }
        return timings;
    }

private:
    void add(const PairKind& kind, Turning turning)
    {
        const Sample& sample = keep(draw_sample(kind, turning, brink_queries));
        const auto add_job = [&](std::string_view who, std::string_view what, const std::vector<Pair>& pairs,
                                 std::size_t count) {
            Timing timing;
            timing.pair = kind.name;
            timing.turning = name_of(turning);
            timing.who = who;
            timing.what = what;
            timing.queries = static_cast<int>(count);
            timing.repetitions = repetitions(turning);
            jobs_.push_back({timing, turning, &sample, &pairs});
        };
        add_job(build_name(), "mixed", sample.mixed, brink_queries);
        if (turning == Turning::none) add_job(build_name(), "mixed time_only", sample.mixed, brink_queries);
        add_job(build_name(), "hits", sample.hits, brink_queries);
        add_job(build_name(), "misses", sample.misses, brink_queries);
        if (!fcl_answers(sample, turning)) return;
        add_job("FCL", "mixed", sample.mixed, fcl_queries);
        for (const Body& body : sample.bodies)
            fcl_[&sample].emplace_back(body.shape);
    }

    int repetitions(Turning turning) const
    {
        if (effort_ == Effort::quick) return quick_repetitions;
        return turning == Turning::none ? still_repetitions : turning_repetitions;
    }

    /// FCL's motions cannot turn by more than a half turn.
    bool fcl_answers(const Sample& sample, Turning turning) const
    {
        return rivals_ == Rivals::fcl && turning != Turning::to_300_degrees &&
               fcl_trusts(support::FclQuestion::conservative_advancement, sample.bodies.front().shape,
                          sample.bodies.back().shape);
    }

    void measure_repetitions(Progress& progress)
    {
        for (std::size_t i = 0; i < jobs_.size(); ++i) {
            benchmark::RegisterBenchmark(std::to_string(i).c_str(),
                                         [this, i, &progress](benchmark::State& state) {
                                             ask(state, jobs_[i]);
                                             progress.step();
                                         })
                ->Iterations(static_cast<benchmark::IterationCount>(jobs_[i].queries()))
                ->Repetitions(jobs_[i].timing.repetitions)
                ->ReportAggregatesOnly();
        }
        std::string name = "brink-bench";
        std::string interleave = "--benchmark_enable_random_interleaving=true";
        std::array arguments{name.data(), interleave.data()};
        int count = static_cast<int>(arguments.size());
        benchmark::Initialize(&count, arguments.data());
        Collector collector(jobs_);
        benchmark::RunSpecifiedBenchmarks(&collector);
        benchmark::ClearRegisteredBenchmarks();
    }

    void ask(benchmark::State& state, const Job& job) const
    {
        const Pair* next = job.pairs->data();
        if (job.fcl()) {
            const std::vector<support::FclBody>& fcl = fcl_.at(job.sample);
            for (auto _ : state)
                benchmark::DoNotOptimize(ask_fcl(job, *next++, fcl));
            return;
        }
        Options options;
        if (job.timing.what == "mixed time_only") options.detail = Detail::time_only;
        for (auto _ : state)
            benchmark::DoNotOptimize(ask_brink(job, *next++, options));
    }

    /// What the mean does not tell: single queries, and distance evaluations.
    void measure_singly(Job& job) const
    {
        const std::vector<Pair>& pairs = *job.pairs;
        const auto one = [&](std::size_t i) {
            if (job.fcl())
                benchmark::DoNotOptimize(ask_fcl(job, pairs[i], fcl_.at(job.sample)));
            else
                benchmark::DoNotOptimize(ask_brink(job, pairs[i], {}));
        };
        const Spread spread = single_queries(job.queries(), one);
        job.timing.p50 = spread.p50;
        job.timing.p99 = spread.p99;
        if (!job.fcl()) count_calls(job);
    }

    const Sample& keep(Sample sample)
    {
        samples_.push_back(std::make_unique<const Sample>(std::move(sample)));
        return *samples_.back();
    }

    Rivals rivals_;
    Effort effort_;
    std::vector<std::unique_ptr<const Sample>> samples_;
    std::map<const Sample*, std::vector<support::FclBody>> fcl_;
    std::vector<Job> jobs_;
};

} // namespace

std::vector<Timing> measure_pairs(Rivals rivals, const std::vector<std::string>& names, Effort effort)
{
    return Bench(rivals, names, effort).run();
}

} // namespace brink::bench
