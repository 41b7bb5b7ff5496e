// SPDX-License-Identifier: BSD-3-Clause
#include "machine.h"
#include "part.h"
#include "replay_report.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace brink::bench {
namespace {

/// Every query of a file asked of brink, and of FCL what it supports, judged by the referee.
class Replay final : public Part {
public:
    std::string_view name() const override { return "replay"; }
    std::string_view about() const override
    {
        return "time per query and wrong answers on queries recorded from a simulation; FCL beside it";
    }
    std::string_view csv() const override { return "replay.csv"; }
    void describe(CLI::App&) override;
    std::uint64_t run(const Output&, Effort) override;
    std::vector<Figure> figures(const Csv&) const override;
    std::vector<Picture> pictures() const override;

private:
    std::string file_ = BRINK_BENCH_WORKLOAD;
};

void Replay::describe(CLI::App& command)
{
    command.add_option("--file", file_, "queries as text")->check(CLI::ExistingFile)->capture_default_str();
}

/// Gives how many objections the referee has: promises broken, and `undecided` where nothing grazes.
std::uint64_t Replay::run(const Output& output, Effort)
{
    const ReplayAnswers answers = ask_all(file_);
    fmt::print("{}\n{}", machine(), replay_tables(answers));
    output.write(csv(), replay_csv(answers));
    fmt::print("\nCSV: {}\n{}\n", output.path_of(csv()), output.draw("replay", replay_plot(answers)));
    for (const std::string& objection : answers.objections)
        fmt::print("brink: {}\n", objection);
    return answers.objections.size();
}

/// The queries that every method answered.
std::vector<Figure> Replay::figures(const Csv& csv) const
{
    std::vector<Figure> figures;
    for (std::size_t i = 0; i < csv.rows(); ++i) {
        if (csv.text(i, "group") != "common") continue;
        figures.push_back({.question = "recorded rubble",
                           .who = csv.text(i, "method"),
                           .time = csv.number(i, "mean_ns"),
                           .error = csv.number(i, "error_p50_steps"),
                           .worst = csv.number(i, "error_worst_steps"),
                           .cases = csv.count(i, "asked"),
                           .missed = csv.count(i, "missed"),
                           .false_hits = csv.count(i, "false_contacts"),
                           .late = csv.count(i, "late")});
    }
    return figures;
}

std::vector<Picture> Replay::pictures() const
{
    return {{"replay",
             "Queries recorded from a rubble pile that is shot at: how many take how long, and how far "
             "their t is off; brink is the most exact and the only one that misses nothing."}};
}

} // namespace

std::unique_ptr<Part> replay_part() { return std::make_unique<Replay>(); }

} // namespace brink::bench
