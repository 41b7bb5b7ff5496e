// SPDX-License-Identifier: BSD-3-Clause
#include "output.h"
#include "replay_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace brink::bench {
namespace {

constexpr double least_error = 1e-16; // smaller ones are drawn here

constexpr Sheet sheet{.svg = {18, 25, 21, 15}, .png = {14, 19, 16, 12}, .lines = "rounded"};

/// Wants the blocks $time0 to $time2 and $error0 to $error2 (value, percent), the headline and subline.
constexpr std::string_view drawing = R"GP(
    set multiplot
    unset key
    set logscale x
    set border 3 linecolor '#555555'
    set tics nomirror
    set grid linecolor '#dddddd' linewidth 1 linetype 1
    set yrange [0:103]
    set ytics 0, 25, 100
    set ytics format '%g %%'
    set tmargin at screen 0.74
    set bmargin at screen 0.16
    set label 1 headline at screen 0.5, 0.95 center font large
    set label 2 subline at screen 0.5, 0.895 center font middle_size textcolor rgb '#444444'
    set lmargin at screen 0.07
    set rmargin at screen 0.48
    set xrange [30:2000000]
    set xtics ('100 ns' 100, '1 µs' 1000, '10 µs' 10000, '100 µs' 100000, '1 ms' 1000000)
    set xlabel 'time of a query (logarithmic)'
    set label 3 'queries answered within that time' at graph 0, 1.05 left font middle_size
    plot for [m = 0:2] '$time' . m using 1:2 with lines linewidth width[m + 1] linecolor rgb colour[m + 1]
    unset label
    set lmargin at screen 0.56
    set rmargin at screen 0.97
    set xrange [1e-16:1]
    set xtics ('10^{-16}' 1e-16, '10^{-12}' 1e-12, '10^{-9}' 1e-9, '10^{-6}' 1e-6, '10^{-3}' 1e-3, '1 step' 1)
    set xlabel 'error of t, fractions of the step (logarithmic)'
    set label 3 'true contacts found, and to that error' at graph 0, 1.05 left font middle_size
    do for [m = 0:2] {
        set label 4 + m method[m + 1] at screen 0.07 + 0.33 * m + 0.045, 0.83 left textcolor rgb colour[m + 1]
        set arrow 1 + m from screen 0.07 + 0.33 * m, 0.83 to screen 0.07 + 0.33 * m + 0.035, 0.83 nohead \
            linewidth width[m + 1] linecolor rgb colour[m + 1]
        set label 8 + m verdict[m + 1] at graph 0.03, 0.94 - 0.075 * m left textcolor rgb colour[m + 1] font small
    }
    plot for [m = 0:2] '$error' . m using 1:2 with lines linewidth width[m + 1] linecolor rgb colour[m + 1]
    unset label
    unset arrow
    unset multiplot
)GP";

/// The values in order, each with the percentage of `whole` that is no larger; as a gnuplot block.
std::string distribution(std::string_view name, std::vector<double> values, std::size_t whole, double end)
{
    std::sort(values.begin(), values.end());
    std::string out = fmt::format("${} << END\n", name);
    const auto percent = [&](std::size_t count) {
        return 100 * static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(whole, 1));
    };
    const std::size_t stride = std::max<std::size_t>(values.size() / 400, 1);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (i % stride == 0 || i + 20 > values.size())
            out += fmt::format("{:.3e} {:.3f}\n", values[i], percent(i + 1));
    return out + fmt::format("{:.3e} {:.3f}\nEND\n", end, percent(values.size()));
}

/// The file's name without what would mean something to gnuplot.
std::string letters_of(const std::string& file)
{
    std::string out = std::filesystem::path(file).stem().string();
    std::replace_if(
        out.begin(), out.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, ' ');
    return out;
}

} // namespace

std::string replay_plot(const ReplayAnswers& answers)
{
    const std::vector<ReplayGroup> groups = replay_groups(answers);
    const auto found =
        std::find_if(groups.begin(), groups.end(), [](const auto& g) { return g.name == "common"; });
    const std::vector<std::size_t> none;
    const std::vector<std::size_t>& common = found == groups.end() ? none : found->queries;
    std::string blocks;
    std::vector<std::string> verdicts;
    std::size_t contacts = 0;
    for (std::size_t m = 0; m < replay_methods.size(); ++m) {
        std::vector<double> times, errors;
        contacts = 0;
        for (const std::size_t i : common) {
            const Said& said = answers.said[m][i];
            times.push_back(std::max(said.ns, 1.0));
            if (answers.facts[i].outcome != Fact::Outcome::meets) continue;
            ++contacts;
            if (said.contact) errors.push_back(std::max(std::abs(said.t - answers.facts[i].t), least_error));
        }
        const ReplayScore score = replay_score(answers, m, common);
        verdicts.push_back(
            fmt::format("\"missed {}, late {}\"", thousands(score.missed), thousands(score.late)));
        blocks += distribution(fmt::format("time{}", m), times, times.size(), 1e9);
        blocks += distribution(fmt::format("error{}", m), errors, contacts, 1);
    }
    return fmt::format("# Draws the replay: gnuplot replay.gp\n"
                       "headline = \"{} recorded queries: {}\"\n"
                       "subline = '{} of which FCL supports too; {} of these first touch within the step'\n"
                       "array colour[3] = ['#007A5A', '#0072B2', '#D55E00']\narray width[3] = [5, 2.5, 2.5]\n"
                       "array method[3] = [\"{}\"]\narray verdict[3] = [{}]\n{}",
                       thousands(static_cast<std::int64_t>(answers.queries.size())), letters_of(answers.file),
                       thousands(static_cast<std::int64_t>(common.size())),
                       thousands(static_cast<std::int64_t>(contacts)), fmt::join(replay_methods, "\", \""),
                       fmt::join(verdicts, ", "), blocks) +
           in_both_formats("replay", sheet, drawing);
}

} // namespace brink::bench
