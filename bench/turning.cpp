// SPDX-License-Identifier: BSD-3-Clause
#include "machine.h"
#include "part.h"
#include "stability_run.h"
#include "turning_case.h"
#include "turning_picture.h"
#include "turning_report.h"

#include <CLI/CLI.hpp>
#include <stress_turning.h>

#include <algorithm>
#include <fmt/format.h>

namespace brink::bench {
namespace {

constexpr std::uint64_t block_size = 20;
constexpr std::uint64_t usual_cases = 100;
constexpr std::uint64_t quick_cases = 10; // see Part::run

struct TurningOptions {
    std::uint64_t cases = 0; // of each pair and class; 0: by default
    std::vector<std::string> pairs{"all"};
    std::vector<std::string> classes{"all"};
    std::uint64_t seed = 20261122;
    std::uint64_t first = 0; // index of the first case, so that a campaign can run in parts
    unsigned threads = 0;    // 0: as many as the machine has
};

std::vector<std::string> turning_pairs()
{
    std::vector<std::string> names;
    for (const support::Pair& pair : support::all_pairs())
        if (!pair.unbounded()) names.push_back(pair.name());
    return names;
}

std::vector<std::string> class_names()
{
    std::vector<std::string> names;
    for (const support::TurningClass& c : support::turning_classes)
        names.emplace_back(c.name);
    return names;
}

std::vector<Block> plan(const TurningOptions& options)
{
    const auto holds = [](const std::vector<std::string>& names, std::string_view name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    std::vector<Block> blocks;
    const std::vector<std::string> names = chosen(options.pairs, turning_pairs());
    const std::vector<std::string> classes = chosen(options.classes, class_names());
    const std::vector<support::Pair> pairs = support::all_pairs();
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        if (!holds(names, pairs[p].name())) continue;
        for (std::size_t k = 0; k < support::turning_classes.size(); ++k) {
            if (!holds(classes, support::turning_classes[k].name)) continue;
            const std::uint64_t end = options.first + options.cases;
            for (std::uint64_t i = options.first; i < end; i += block_size)
                blocks.push_back({pairs[p], {p, k, 0}, options.seed, i, std::min(end, i + block_size)});
        }
    }
    return blocks;
}

/// What Stability measures, for every pair and where bodies turn: against promise 3, and not in units of the
/// last place, for no answer to these is exact.
class TurningStability final : public Part {
public:
    std::string_view name() const override { return "turning"; }
    std::string_view about() const override
    {
        return "stability of every pair where bodies turn, by 1e-12 to 100 turns, against 100 digits; FCL "
               "beside it";
    }
    std::string_view csv() const override { return "turning.csv"; }
    void describe(CLI::App&) override;
    std::uint64_t run(const Output&, Effort) override;
    std::vector<Figure> figures(const Csv& csv) const override { return figures_by_pair(csv, ", turning"); }
    std::vector<Picture> pictures() const override;

private:
    TurningOptions options_;
};

void TurningStability::describe(CLI::App& command)
{
    command.add_option("--cases", options_.cases, fmt::format("of each pair and class; 0: {}", usual_cases))
        ->capture_default_str();
    add_choice(command, "--pairs", options_.pairs, turning_pairs());
    add_choice(command, "--classes", options_.classes, class_names());
    command.add_option("--seed", options_.seed, "of the random cases")->capture_default_str();
    command
        .add_option("--first", options_.first, "index of the first case: to go on where another run ended")
        ->capture_default_str();
    command.add_option("--threads", options_.threads, "workers, each with an FCL process of its own; 0: all")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
}

std::uint64_t TurningStability::run(const Output& output, Effort effort)
{
    if (!have_referee) {
        fmt::print("turning is judged in 100 digits, and this build has none "
                   "(Debian: libboost-dev libmpfr-dev libgmp-dev; then configure again): left out\n");
        return 0;
    }
    TurningOptions options = options_;
    if (options.cases == 0) options.cases = effort == Effort::quick ? quick_cases : usual_cases;
    const Scores scores = measure_all("turning", plan(options), measure_turning, options.threads);
    output.write(csv(), turning_csv(scores));
    fmt::print("{}\n{}\n", machine(), turning_table(scores));
    print_complaints(scores, [](std::size_t kind) { return support::turning_classes[kind].name; });
    fmt::print("{}\n", output.draw("turning", turning_plot(scores)));
    fmt::print("Figures: {}\n", output.path_of(csv()));
    return broken(scores);
}

std::vector<Picture> TurningStability::pictures() const
{
    return {{"turning", "However hard the query, the gap that brink leaves stays below the line of what it "
                        "promises, and no contact is missed or late."}};
}

} // namespace

std::unique_ptr<Part> turning_part() { return std::make_unique<TurningStability>(); }

} // namespace brink::bench
