// SPDX-License-Identifier: BSD-3-Clause
#include "machine.h"
#include "pair_bench.h"
#include "pairs_picture.h"
#include "pairs_report.h"
#include "part.h"

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <memory>

namespace brink::bench {
namespace {

/// What `sibling pairs --rows` prints; empty where it fails.
std::vector<Timing> ask_sibling(const std::vector<std::string>& names, const std::filesystem::path& sibling,
                                Effort effort)
{
    const std::string command = fmt::format("{} pairs --rows --pairs {}{}", shell_quoted(sibling.string()),
                                            fmt::join(names, ","), effort == Effort::quick ? " --quick" : "");
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    if (!pipe) return {};
    std::string text;
    std::array<char, 4096> block{};
    while (const std::size_t got = std::fread(block.data(), 1, block.size(), pipe.get()))
        text.append(block.data(), got);
    return parse_timings(text);
}

/// Why there are no figures of the wider build; empty if there are.
std::string add_wider_build(std::vector<Timing>& timings, const std::vector<std::string>& names,
                            Effort effort)
{
    const std::filesystem::path sibling =
        std::filesystem::canonical("/proc/self/exe").replace_filename("brink-bench-v3");
    if (!runs_v3()) return "this processor does not run x86-64-v3";
    if (!std::filesystem::exists(sibling)) return fmt::format("there is no {}", sibling.filename().string());
    const std::vector<Timing> wider = ask_sibling(names, sibling, effort);
    timings.insert(timings.end(), wider.begin(), wider.end());
    return wider.empty() ? fmt::format("{} failed", sibling.filename().string()) : "";
}

void draw(const Output& output, const std::vector<Timing>& timings, Turning turning, std::string_view stem)
{
    const std::string plot = pairs_plot(timings, turning, stem);
    if (!plot.empty()) fmt::print("{}\n", output.draw(stem, plot));
}

/// ns per query of this build and of the x86-64-v3 build of the library (asked from the same program over
/// that build, if there is one that runs here), with FCL's conservative advancement beside them.
class Pairs final : public Part {
public:
    std::string_view name() const override { return "pairs"; }
    std::string_view about() const override
    {
        return "ns per query of pairs that move straight and pairs that turn, FCL beside it";
    }
    std::string_view csv() const override { return "pairs.csv"; }
    void describe(CLI::App&) override;
    std::uint64_t run(const Output&, Effort) override;
    std::vector<Figure> figures(const Csv&) const override;
    std::vector<Picture> pictures() const override;

private:
    std::vector<std::string> pairs_{"all"};
    bool rows_ = false; // only print this build's rows
};

void Pairs::describe(CLI::App& command)
{
    add_choice(command, "--pairs", pairs_, pair_names());
    command.add_flag("--rows", rows_,
                     "only print this build's rows, as CSV on stdout (how brink-bench asks brink-bench-v3)");
}

std::uint64_t Pairs::run(const Output& output, Effort effort)
{
    const std::vector<std::string> names = chosen(pairs_, pair_names());
    if (rows_) {
        fmt::print("{}", timings_csv(measure_pairs(Rivals::none, names, effort)));
        return 0;
    }
    std::vector<Timing> timings = measure_pairs(Rivals::fcl, names, effort);
    const std::string missing = add_wider_build(timings, names, effort);
    output.write(csv(), timings_csv(timings));
    fmt::print("{}\n", machine());
    for (const std::string& table :
         {translation_table(timings), turning_table(timings, Turning::to_60_degrees),
          turning_table(timings, Turning::to_300_degrees)})
        if (!table.empty()) fmt::print("\n{}", table);
    if (!missing.empty()) fmt::print("\nNo figures of the x86-64-v3 build: {}.\n", missing);
    fmt::print("\n");
    draw(output, timings, Turning::none, "pairs");
    draw(output, timings, Turning::to_60_degrees, "pairs_turning");
    fmt::print("Figures: {}\n", output.path_of(csv()));
    return 0;
}

/// Mixed queries with everything asked, of this build and of the wider one.
std::vector<Figure> Pairs::figures(const Csv& csv) const
{
    std::vector<Figure> figures;
    for (std::size_t i = 0; i < csv.rows(); ++i) {
        const std::string& who = csv.text(i, "who");
        const std::string& turning = csv.text(i, "turning");
        if (csv.text(i, "what") != "mixed") continue;
        figures.push_back(
            {.question = csv.text(i, "pair") + (turning == "none" ? " straight" : " turning to " + turning),
             .who = who == "baseline" ? "brink"
                    : who == "FCL"    ? who
                                      : "brink " + who,
             .time = csv.number(i, "ns_per_query"),
             .spread = csv.number(i, "standard_deviation_ns")});
    }
    return figures;
}

std::vector<Picture> Pairs::pictures() const
{
    return {
        {"pairs", "Bodies that move straight: ns of one query, brink's bars and FCL's."},
        {"pairs_turning", "Bodies that turn by up to 60 degrees: ns of one query, brink's bars and FCL's."}};
}

} // namespace

std::unique_ptr<Part> pairs_part() { return std::make_unique<Pairs>(); }

} // namespace brink::bench
