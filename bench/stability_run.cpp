// SPDX-License-Identifier: BSD-3-Clause
#include "stability_run.h"

#include "output.h"

#include <algorithm>
#include <atomic>
#include <fmt/format.h>
#include <map>
#include <mutex>
#include <thread>

namespace brink::bench {
namespace {

constexpr int fcl_patience_ms = 100; // one answer takes microseconds, where it does not hang
constexpr std::size_t complaints_shown = 4;

} // namespace

Scores measure_all(std::string_view what, const std::vector<Block>& blocks,
                   Scores (*measure)(const Block&, support::FclProcess&), unsigned threads)
{
    Scores scores;
    Progress progress(what, static_cast<int>(blocks.size()));
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
    if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::thread> workers;
    for (unsigned i = 0; i < threads; ++i)
        workers.emplace_back(work);
    for (std::thread& worker : workers)
        worker.join();
    return scores;
}

void print_complaints(const Scores& scores, std::string_view (*class_name)(std::size_t kind))
{
    std::vector<Complaint> first = scores.complaints;
    std::sort(first.begin(), first.end(),
              [](const Complaint& a, const Complaint& b) { return a.precedes(b); });
    for (std::size_t i = 0; i < std::min(first.size(), complaints_shown); ++i)
        fmt::print("{}, {}, case {}:\n{}\n", support::all_pairs()[first[i].spot.pair].name(),
                   class_name(first[i].spot.kind), first[i].index, first[i].text);
    if (first.size() > complaints_shown)
        fmt::print("... and one at least in {} more pairs and classes.\n", first.size() - complaints_shown);
}

std::uint64_t broken(const Scores& scores)
{
    std::uint64_t sum = 0;
    for (const auto& [spot, by_solver] : scores.at)
        sum += by_solver[static_cast<std::size_t>(Solver::brink)].broken;
    return sum;
}

std::vector<Figure> figures_by_pair(const Csv& csv, std::string_view motion)
{
    std::map<std::pair<std::string, std::string>, Figure> sums;
    for (std::size_t i = 0; i < csv.rows(); ++i) {
        const std::string &pair = csv.text(i, "pair"), &solver = csv.text(i, "method");
        Figure& f = sums[{pair, solver}];
        if (f.cases < 0)
            f = {.question = fmt::format("{}{}", pair, motion),
                 .who = solver,
                 .cases = 0,
                 .wrong = 0,
                 .late = 0};
        f.cases += csv.count(i, "cases");
        f.late += csv.count(i, "late");
        f.wrong += csv.count(i, "wrong");
    }
    std::vector<Figure> figures;
    for (auto& [key, figure] : sums)
        figures.push_back(std::move(figure));
    return figures;
}

} // namespace brink::bench
