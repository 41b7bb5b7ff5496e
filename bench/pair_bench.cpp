// SPDX-License-Identifier: BSD-3-Clause
#include "pair_bench.h"

#include "machine.h"
#include "output.h"
#include "pair_sample.h"

#include <algorithm>
#include <array>
#include <benchmark/benchmark.h>
#include <fcl.h>
#include <fmt/format.h>

#include <cstdio>
#include <map>
#include <memory>
#include <sstream>

namespace brink::bench {
namespace {

constexpr int repetitions = 15;
constexpr std::size_t closed_queries = 262'144;
constexpr std::size_t rotating_queries = 4'096; // advancement is slow, and no branch repeats itself in it
constexpr std::size_t fcl_queries = 4'096;

/// What one benchmark asks, over and over: a list of pairs, as many as a repetition has iterations.
struct Job {
    std::string pair, who, what;
    const Sample* sample;
    const std::vector<Pair>* pairs;
    std::size_t queries;
};

void ask_brink(benchmark::State& state, const Job& job, Options options)
{
    const std::vector<Body>& bodies = job.sample->bodies;
    const Pair* next = job.pairs->data();
    for (auto _ : state) {
        const Body& a = bodies[next->a];
        const Body& b = bodies[next->b];
        ++next;
        const Toi toi = time_of_impact(a.shape, a.motion, b.shape, b.motion, options);
        benchmark::DoNotOptimize(toi);
    }
}

void ask_fcl(benchmark::State& state, const Job& job, const std::vector<support::FclBody>& fcl)
{
    const std::vector<Body>& bodies = job.sample->bodies;
    const Pair* next = job.pairs->data();
    for (auto _ : state) {
        const auto t = fcl_continuous(support::FclQuestion::conservative_advancement, fcl[next->a],
                                      bodies[next->a].motion, fcl[next->b], bodies[next->b].motion);
        ++next;
        benchmark::DoNotOptimize(t);
    }
}

/// Collects the means and deviations that Google Benchmark makes of the repetitions.
class Collector : public benchmark::BenchmarkReporter {
public:
    explicit Collector(const std::vector<Job>& jobs) : jobs_(jobs) {}

    bool ReportContext(const Context&) override { return true; }

    void ReportRuns(const std::vector<Run>& runs) override
    {
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Aggregate) continue;
            const Job& job = jobs_[std::stoul(run.run_name.function_name)];
            Timing& timing = by_job_[&job];
            timing.pair = job.pair;
            timing.who = job.who;
            timing.what = job.what;
            timing.queries = static_cast<int>(job.queries);
            timing.repetitions = repetitions;
            if (run.aggregate_name == "mean") timing.ns = run.GetAdjustedCPUTime();
            if (run.aggregate_name == "stddev") timing.deviation = run.GetAdjustedCPUTime();
        }
    }

    std::vector<Timing> timings() const
    {
        std::vector<Timing> all;
        for (const auto& [job, timing] : by_job_)
            all.push_back(timing);
        return all;
    }

private:
    const std::vector<Job>& jobs_;
    std::map<const Job*, Timing> by_job_; // in the order of the jobs
};

/// Everything to be measured, and what it is measured on.
class Bench {
public:
    Bench(Rivals rivals, const std::vector<std::string>& names) : rivals_(rivals)
    {
        const auto named = [&](const PairKind& kind) {
            return std::find(names.begin(), names.end(), kind.name) != names.end();
        };
        for (const PairKind& kind : closed_pairs())
            if (named(kind)) add_closed(kind);
        for (const PairKind& kind : rotating_pairs())
            if (named(kind)) add_rotating(kind);
    }

    std::vector<Timing> run()
    {
        Progress progress(fmt::format("pairs, {}", build_name()),
                          static_cast<int>(jobs_.size()) * repetitions);
        for (std::size_t i = 0; i < jobs_.size(); ++i) {
            benchmark::RegisterBenchmark(std::to_string(i).c_str(),
                                         [this, i, &progress](benchmark::State& state) {
                                             ask(state, jobs_[i]);
                                             progress.step();
                                         })
                ->Iterations(static_cast<benchmark::IterationCount>(jobs_[i].queries))
                ->Repetitions(repetitions)
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
        return collector.timings();
    }

private:
    void add_closed(const PairKind& kind)
    {
        const Sample& sample = keep(draw_sample(kind, Turning::none, closed_queries));
        const std::string pair(kind.name);
        jobs_.push_back({pair, build_name(), "mixed", &sample, &sample.mixed, closed_queries});
        jobs_.push_back({pair, build_name(), "mixed time_only", &sample, &sample.mixed, closed_queries});
        jobs_.push_back({pair, build_name(), "hits", &sample, &sample.hits, closed_queries});
        jobs_.push_back({pair, build_name(), "misses", &sample, &sample.misses, closed_queries});
        add_rival({pair, "FCL", "mixed", &sample, &sample.mixed, fcl_queries});
    }

    void add_rotating(const PairKind& kind)
    {
        const Sample& sample = keep(draw_sample(kind, Turning::to_60_degrees, rotating_queries));
        const std::string pair(kind.name);
        jobs_.push_back({pair, build_name(), "rotating", &sample, &sample.mixed, rotating_queries});
        add_rival({pair, "FCL", "rotating", &sample, &sample.mixed, fcl_queries});
    }

    void add_rival(const Job& job)
    {
        const std::vector<Body>& bodies = job.sample->bodies;
        const auto advancement = support::FclQuestion::conservative_advancement;
        if (rivals_ == Rivals::none || !fcl_trusts(advancement, bodies.front().shape, bodies.back().shape))
            return;
        auto& prepared = fcl_[job.sample];
        if (prepared.empty())
            for (const Body& body : bodies)
                prepared.emplace_back(body.shape);
        jobs_.push_back(job);
    }

    void ask(benchmark::State& state, const Job& job) const
    {
        Options options;
        if (job.what == "mixed time_only") options.detail = Detail::time_only;
        if (job.who == "FCL")
            ask_fcl(state, job, fcl_.at(job.sample));
        else
            ask_brink(state, job, options);
    }

    const Sample& keep(Sample sample)
    {
        samples_.push_back(std::make_unique<const Sample>(std::move(sample)));
        return *samples_.back();
    }

    Rivals rivals_;
    std::vector<std::unique_ptr<const Sample>> samples_;
    std::map<const Sample*, std::vector<support::FclBody>> fcl_;
    std::vector<Job> jobs_;
};

} // namespace

std::vector<Timing> measure_pairs(Rivals rivals, const std::vector<std::string>& names)
{
    return Bench(rivals, names).run();
}

std::string timings_csv(const std::vector<Timing>& timings)
{
    std::string text = "pair,who,what,ns_per_query,standard_deviation_ns,queries,repetitions\n";
    for (const Timing& t : timings)
        text += fmt::format("{},{},{},{:.2f},{:.2f},{},{}\n", t.pair, t.who, t.what, t.ns, t.deviation,
                            t.queries, t.repetitions);
    return text;
}

std::vector<Timing> parse_timings(std::string_view csv)
{
    std::vector<Timing> timings;
    std::istringstream lines{std::string(csv)};
    for (std::string line; std::getline(lines, line);) {
        Timing t;
        std::istringstream cells(line);
        std::getline(cells, t.pair, ',');
        std::getline(cells, t.who, ',');
        std::getline(cells, t.what, ',');
        char comma = 0;
        if (cells >> t.ns >> comma >> t.deviation >> comma >> t.queries >> comma >> t.repetitions)
            timings.push_back(t);
    }
    return timings;
}

} // namespace brink::bench
