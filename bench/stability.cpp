// SPDX-License-Identifier: BSD-3-Clause
#include "stability.h"

#include "machine.h"
#include "stability_case.h"
#include "stability_picture.h"
#include "stability_report.h"

#include <stress.h>

#include <algorithm>
#include <atomic>
#include <fmt/format.h>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace brink::bench {
namespace {

constexpr std::uint64_t block_size = 100;
constexpr int fcl_patience_ms = 100; // one answer takes microseconds, where it does not hang
constexpr std::size_t complaints_shown = 4;

std::uint64_t cases_of(const StabilityOptions& options, const support::Pair& pair)
{
    if (options.cases > 0) return options.cases;
    return pair.second == 0 ? 20'000 : 2'000;
}

bool wanted(const std::vector<std::string>& names, std::string_view name)
{
    const auto is = [&](const std::string& n) { return n == name || n == "all"; };
    return std::any_of(names.begin(), names.end(), is);
}

std::vector<Block> plan(const StabilityOptions& options)
{
    std::vector<Block> blocks;
    const std::vector<support::Pair> pairs = support::all_pairs();
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        if (!pairs[p].closed_form() || !wanted(options.pairs, pairs[p].name())) continue;
        for (std::size_t k = 0; k < support::stress_classes.size(); ++k) {
            if (!wanted(options.classes, support::stress_classes[k].name)) continue;
            const std::uint64_t end = options.first + cases_of(options, pairs[p]);
            for (std::uint64_t i = options.first; i < end; i += block_size)
                blocks.push_back({pairs[p], {p, k, 0}, options.seed, i, std::min(end, i + block_size)});
        }
    }
    return blocks;
}

/// Each worker has an FCL process of its own.
Scores measure(const std::vector<Block>& blocks, std::size_t threads)
{
    Scores scores;
    Progress progress("stability", static_cast<int>(blocks.size()));
    std::mutex mutex;
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        support::FclProcess fcl(fcl_patience_ms);
        for (std::size_t i = next++; i < blocks.size(); i = next++) {
            const Scores more = measure(blocks[i], fcl);
            const std::scoped_lock lock(mutex);
            scores.add(more);
            progress.step();
        }
    };
    std::vector<std::thread> workers;
    for (std::size_t i = 0; i < threads; ++i)
        workers.emplace_back(work);
    for (std::thread& worker : workers)
        worker.join();
    return scores;
}

void print_complaints(const Scores& scores)
{
    std::vector<Complaint> first = scores.complaints;
    std::sort(first.begin(), first.end(),
              [](const Complaint& a, const Complaint& b) { return a.precedes(b); });
    for (std::size_t i = 0; i < std::min(first.size(), complaints_shown); ++i)
        fmt::print("{}, {}, case {}:\n{}\n", support::all_pairs()[first[i].spot.pair].name(),
                   support::stress_classes[first[i].spot.kind].name, first[i].index, first[i].text);
    if (first.size() > complaints_shown)
        fmt::print("... and one at least in {} more pairs and classes.\n", first.size() - complaints_shown);
}

} // namespace

std::vector<std::string> stability_pairs()
{
    std::vector<std::string> names;
    for (const support::Pair& pair : support::all_pairs())
        if (pair.closed_form()) names.push_back(pair.name());
    return names;
}

std::vector<std::string> stability_classes()
{
    std::vector<std::string> names;
    for (const support::StressClass& c : support::stress_classes)
        names.emplace_back(c.name);
    return names;
}

std::uint64_t run_stability(const Output& output, const StabilityOptions& options)
{
    if (!have_referee)
        throw std::runtime_error("stability is judged in 200 digits, and this build has none "
                                 "(Debian: libboost-dev libmpfr-dev libgmp-dev; then configure again)");
    const unsigned threads = options.threads > 0 ? static_cast<unsigned>(options.threads)
                                                 : std::max(1U, std::thread::hardware_concurrency());
    const Scores scores = measure(plan(options), threads);
    output.write("stability.csv", stability_csv(scores));
    fmt::print("{}\n{}\n", machine(), stability_table(scores));
    print_complaints(scores);
    fmt::print("{}\n", output.draw("stability", stability_plot(scores)));
    fmt::print("Figures: {}\n", output.path_of("stability.csv"));
    std::uint64_t broken = 0;
    for (const auto& [spot, by_solver] : scores.at)
        broken += by_solver[static_cast<std::size_t>(Solver::brink)].broken;
    return broken;
}

} // namespace brink::bench
