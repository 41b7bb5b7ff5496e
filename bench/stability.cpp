// SPDX-License-Identifier: BSD-3-Clause
#include "machine.h"
#include "part.h"
#include "stability_case.h"
#include "stability_picture.h"
#include "stability_report.h"
#include "stability_run.h"

#include <CLI/CLI.hpp>
#include <stress.h>

#include <algorithm>
#include <fmt/format.h>

namespace brink::bench {
namespace {

constexpr std::uint64_t block_size = 100;
constexpr std::uint64_t quick_cases = 200; // see Part::run

struct StabilityOptions {
    std::uint64_t cases = 0; // of each pair and class; 0: by default
    std::vector<std::string> pairs{"all"};
    std::vector<std::string> classes{"all"};
    std::uint64_t seed = 20261122;
    std::uint64_t first = 0; // index of the first case, so that a campaign can run in parts
    unsigned threads = 0;    // 0: as many as the machine has
};

std::uint64_t cases_of(const StabilityOptions& options, const support::Pair& pair)
{
    if (options.cases > 0) return options.cases;
    return pair.second == 0 ? 20'000 : 2'000;
}

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

bool holds(const std::vector<std::string>& names, std::string_view name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<Block> plan(const StabilityOptions& options)
{
    std::vector<Block> blocks;
    const std::vector<std::string> names = chosen(options.pairs, stability_pairs());
    const std::vector<std::string> classes = chosen(options.classes, stability_classes());
    const std::vector<support::Pair> pairs = support::all_pairs();
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        if (!pairs[p].closed_form() || !holds(names, pairs[p].name())) continue;
        for (std::size_t k = 0; k < support::stress_classes.size(); ++k) {
            if (!holds(classes, support::stress_classes[k].name)) continue;
            const std::uint64_t end = options.first + cases_of(options, pairs[p]);
            for (std::uint64_t i = options.first; i < end; i += block_size)
                blocks.push_back({pairs[p], {p, k, 0}, options.seed, i, std::min(end, i + block_size)});
        }
    }
    return blocks;
}

/// Error of t and wrong decisions of brink, the textbook's formulas and FCL, pair by pair and class by class,
/// against the referee of 200 digits.
class Stability final : public Part {
public:
    std::string_view name() const override { return "stability"; }
    std::string_view about() const override
    {
        return "error of t and wrong decisions where it is hard, against 200 digits; textbook formulas and "
               "FCL "
               "beside it";
    }
    std::string_view csv() const override { return "stability.csv"; }
    void describe(CLI::App&) override;
    std::uint64_t run(const Output&, Effort) override;
    std::vector<Figure> figures(const Csv& csv) const override { return figures_by_pair(csv, ""); }
    std::vector<Picture> pictures() const override;

private:
    StabilityOptions options_;
};

void Stability::describe(CLI::App& command)
{
    command
        .add_option("--cases", options_.cases,
                    "of each pair and class; 0: 20,000 of two spheres, 2,000 of the others")
        ->capture_default_str();
    add_choice(command, "--pairs", options_.pairs, stability_pairs());
    add_choice(command, "--classes", options_.classes, stability_classes());
    command.add_option("--seed", options_.seed, "of the random cases")->capture_default_str();
    command
        .add_option("--first", options_.first, "index of the first case: to go on where another run ended")
        ->capture_default_str();
    command.add_option("--threads", options_.threads, "workers, each with an FCL process of its own; 0: all")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
}

std::uint64_t Stability::run(const Output& output, Effort effort)
{
    if (!have_referee) {
        fmt::print("stability is judged in 200 digits, and this build has none "
                   "(Debian: libboost-dev libmpfr-dev libgmp-dev; then configure again): left out\n");
        return 0;
    }
    StabilityOptions options = options_;
    if (effort == Effort::quick && options.cases == 0) options.cases = quick_cases;
    const Scores scores = measure_all("stability", plan(options), measure, options.threads);
    output.write(csv(), stability_csv(scores));
    fmt::print("{}\n{}\n", machine(), stability_table(scores));
    print_complaints(scores, [](std::size_t kind) { return support::stress_classes[kind].name; });
    fmt::print("{}\n", output.draw("stability", stability_plot(scores)));
    fmt::print("Figures: {}\n", output.path_of(csv()));
    return broken(scores);
}

std::vector<Picture> Stability::pictures() const
{
    return {{"stability", "No cross in brink's rows: no wrong hit or miss, however hard the query."}};
}

} // namespace

std::unique_ptr<Part> stability_part() { return std::make_unique<Stability>(); }

} // namespace brink::bench
