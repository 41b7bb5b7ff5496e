// SPDX-License-Identifier: BSD-3-Clause
#include "pairs.h"

#include "machine.h"
#include "pair_bench.h"
#include "pairs_picture.h"
#include "pairs_report.h"

#include <array>
#include <cstdio>
#include <fmt/format.h>
#include <memory>

namespace brink::bench {
namespace {

/// What `sibling pairs --rows` prints; empty where it fails.
std::vector<Timing> ask_sibling(const std::vector<std::string>& names, const std::filesystem::path& sibling)
{
    const std::string command =
        fmt::format("{} pairs --rows --pairs {}", shell_quoted(sibling.string()), fmt::join(names, ","));
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
                            const std::filesystem::path& sibling)
{
    if (!runs_v3()) return "this processor does not run x86-64-v3";
    if (!std::filesystem::exists(sibling)) return fmt::format("there is no {}", sibling.filename().string());
    const std::vector<Timing> wider = ask_sibling(names, sibling);
    timings.insert(timings.end(), wider.begin(), wider.end());
    return wider.empty() ? fmt::format("{} failed", sibling.filename().string()) : "";
}

void draw(const Output& output, const std::vector<Timing>& timings, Turning turning, std::string_view stem)
{
    const std::string plot = pairs_plot(timings, turning, stem);
    if (!plot.empty()) fmt::print("{}\n", output.draw(stem, plot));
}

} // namespace

void run_pairs(const Output& output, const std::vector<std::string>& names,
               const std::filesystem::path& sibling)
{
    std::vector<Timing> timings = measure_pairs(Rivals::fcl, names);
    const std::string missing = add_wider_build(timings, names, sibling);
    output.write("pairs.csv", timings_csv(timings));
    fmt::print("{}\n", machine());
    for (const std::string& table :
         {translation_table(timings), turning_table(timings, Turning::to_60_degrees),
          turning_table(timings, Turning::to_300_degrees)})
        if (!table.empty()) fmt::print("\n{}", table);
    if (!missing.empty()) fmt::print("\nNo figures of the x86-64-v3 build: {}.\n", missing);
    fmt::print("\n");
    draw(output, timings, Turning::none, "pairs");
    draw(output, timings, Turning::to_60_degrees, "pairs_turning");
    fmt::print("Figures: {}\n", output.path_of("pairs.csv"));
}

} // namespace brink::bench
