// SPDX-License-Identifier: BSD-3-Clause
#include "stability_picture.h"

#include "output.h"

#include <stress.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace brink::bench {
namespace {

constexpr Sheet sheet{.height = 820, .svg = {15, 25, 18, 13}, .png = {11.5, 19, 14, 10}};

/// The panels and everything else but the figures. Wants headline, subline, verdict and $cells: class, solver
/// (3 is on top), level from, to, decimal logarithm of the worst error in ulp (-1: nothing to compare), wrong
/// decisions; and the arrays title, quantity, first, last; @ticks is replaced by the axis of panel k.
constexpr std::string_view formulas = R"GP(
array who[4] = ['FCL advancement', 'stable root', 'textbook root', 'brink']
pick(k, known) = column(1) == k && (column(5) >= 0) == known ? column(2) : NaN
middle(a, b) = 0.5 * (column(a) + column(b))
columns = 5
)GP";

constexpr std::string_view drawing = R"GP(
    set multiplot
    set palette defined (0 '#d3e9f7', 2 '#9ecae1', 4 '#fee391', 8 '#fe9929', 12 '#cc4c02', 16 '#5c1a05')
    set cbrange [0:16]
    unset colorbox
    unset key
    set style fill solid 1 noborder
    set yrange [-0.5:3.5]
    set border 0
    set tics scale 0
    do for [k = 1:|title|] {
        i = (k - 1) % columns
        j = (k - 1) / columns
        set lmargin at screen 0.115 + 0.177 * i
        set rmargin at screen 0.115 + 0.177 * i + 0.163
        set tmargin at screen 0.775 - 0.375 * j
        set bmargin at screen 0.775 - 0.375 * j - 0.215
        set xrange [first[k]:last[k]]
        if (i == 0) {
            set ytics (who[1] 0, who[2] 1, who[3] 2, who[4] 3)
        } else {
            set ytics ('' 0)
        }
        @ticks
        set label 1 title[k] at graph 0, 1.10 left font middle_size
        set xlabel quantity[k] font small offset 0, 0.6
        if (k == 1) {
            set label 2 headline at screen 0.5, 0.962 center font large
            set label 3 subline at screen 0.5, 0.912 center textcolor rgb '#444444' font middle_size
            set label 9 verdict at screen 0.5, 0.868 center font middle_size
            set label 4 'a wrong hit or miss' at screen 0.71, 0.052 left
            set label 5 '×' at screen 0.695, 0.052 center font middle_size
            set label 6 'nothing to compare' at screen 0.875, 0.052 left
            set object 1 rectangle from screen 0.845, 0.038 to screen 0.868, 0.066 fillcolor rgb '#e4e4e4' fillstyle solid 1 noborder
            set colorbox horizontal user origin 0.30, 0.038 size 0.36, 0.028
            set cbtics ('1' 0, '10^{4}' 4, '10^{8}' 8, '10^{12}' 12, '10^{16}' 16) offset 0, 0.4
            set label 7 'worst error of t,' at screen 0.285, 0.063 right
            set label 8 'in units in the last place' at screen 0.285, 0.037 right
        }
        plot $cells using (middle(3, 4)):(pick(k, 0)):3:4:(column(2) - 0.42):(column(2) + 0.42) \
                 with boxxyerror fillcolor rgb '#e4e4e4', \
             $cells using (middle(3, 4)):(pick(k, 1)):3:4:(column(2) - 0.42):(column(2) + 0.42):5 \
                 with boxxyerror fillcolor palette, \
             $cells using (middle(3, 4)):(column(1) == k && column(6) > 0 ? column(2) : NaN):('×') \
                 with labels textcolor rgb '#000000' font middle_size
        unset label
        unset object
        unset colorbox
    }
    unset multiplot
)GP";

constexpr std::array<Solver, 4> bottom_up{Solver::fcl, Solver::stable, Solver::textbook, Solver::brink};

/// One class, level and solver: over all pairs.
Score pooled(const Scores& scores, std::size_t kind, std::size_t step, Solver solver)
{
    Score sum;
    for (const auto& [spot, by_solver] : scores.at)
        if (spot.kind == kind && spot.step == step) sum.add(by_solver[static_cast<std::size_t>(solver)]);
    return sum;
}

std::string cells(const Scores& scores, const std::set<std::size_t>& kinds)
{
    std::string text = "$cells << END\n";
    std::size_t panel = 0;
    for (const std::size_t kind : kinds) {
        const support::StressClass& c = support::stress_classes[kind];
        ++panel;
        for (std::size_t step = 0; c.first + static_cast<double>(step) * c.decades < c.last; ++step) {
            const double from = c.first + static_cast<double>(step) * c.decades;
            for (std::size_t i = 0; i < bottom_up.size(); ++i) {
                const Score s = pooled(scores, kind, step, bottom_up[i]);
                const double worst = s.ulps.empty() ? -1 : std::log10(std::clamp(s.ulp_at(1), 1.0, 1e16));
                text += fmt::format("{} {} {:g} {:g} {:.3f} {}\n", panel, i, from, from + c.decades, worst,
                                    s.wrong);
            }
        }
    }
    return text + "END\n";
}

/// Where the axis of a class has its numbers: at powers of ten with room between them, none at the right end,
/// where the next panel begins; "0" at the step that holds exact zeros.
std::string ticks(const support::StressClass& c)
{
    if (c.stress == support::Stress::random) return "'' 0";
    const bool zero = c.stress == support::Stress::parallel || c.stress == support::Stress::touching;
    const double span = c.last - c.first;
    const double every = span > 100 ? 100 : span > 8 ? 4 : 2;
    std::string text = zero ? fmt::format("'0' {}", c.first + 0.5) : "";
    for (double at = std::ceil((c.first + (zero ? 2 : 0)) / every) * every; at < c.last; at += every)
        text += fmt::format("{}'10^{{{:g}}}' {:g}", text.empty() ? "" : ", ", at, at);
    return text;
}

std::string titled(std::string_view name)
{
    std::string title(name);
    std::replace(title.begin(), title.end(), '_', ' ');
    return title == "t max" ? "contact at t_{max}" : title;
}

std::string axis_name(const support::StressClass& c)
{
    if (c.stress == support::Stress::random) return "no difficulty";
    return c.stress == support::Stress::t_max ? "t_{max}" : std::string(c.quantity);
}

std::string array(std::string_view name, const std::vector<std::string>& items)
{
    return fmt::format("array {}[{}] = [{}]\n", name, items.size(), fmt::join(items, ", "));
}

std::string share(std::uint64_t part, std::uint64_t whole)
{
    if (part == 0) return "0";
    const double percent = 100 * static_cast<double>(part) / static_cast<double>(whole);
    if (percent < 0.01) return "<0.01 %";
    return fmt::format("{:.{}f} %", percent, percent < 0.1 ? 2 : percent < 10 ? 1 : 0);
}

/// "brink: 0 wrong, 0 late" and so on for every solver that was asked.
std::string verdict(const Scores& scores)
{
    constexpr std::array<std::string_view, 4> titles{"brink", "textbook root", "stable root", "FCL"};
    std::string text;
    for (std::size_t i = 0; i < titles.size(); ++i) {
        Score sum;
        for (const auto& [spot, by_solver] : scores.at) {
            sum.cases += by_solver[i].cases;
            sum.wrong += by_solver[i].wrong;
            sum.late += by_solver[i].late;
        }
        if (sum.cases > 0)
            text += fmt::format("{}{}: {} wrong, {} late", i == 0 ? "" : "      ", titles[i],
                                share(sum.wrong, sum.cases), share(sum.late, sum.cases));
    }
    return text;
}

std::string scope(const std::set<std::size_t>& pairs)
{
    if (pairs.size() > 1) return fmt::format("{} pairs of shapes in translation", pairs.size());
    std::string name = support::all_pairs()[*pairs.begin()].name();
    std::replace(name.begin(), name.end(), '_', '-');
    return name + " in translation";
}

} // namespace

std::string stability_plot(const Scores& scores)
{
    std::set<std::size_t> kinds;
    std::set<std::size_t> pairs;
    std::uint64_t cases = 0;
    for (const auto& [spot, by_solver] : scores.at) {
        kinds.insert(spot.kind);
        pairs.insert(spot.pair);
        cases += by_solver[0].cases;
    }
    std::vector<std::string> titles, quantities, firsts, lasts, tick_commands;
    for (const std::size_t kind : kinds) {
        const support::StressClass& c = support::stress_classes[kind];
        titles.push_back(fmt::format("\"{}\"", titled(c.name)));
        quantities.push_back(fmt::format("\"{}\"", axis_name(c)));
        firsts.push_back(fmt::format("{:g}", c.first));
        lasts.push_back(fmt::format("{:g}", c.last));
        tick_commands.push_back(ticks(c));
    }
    std::string text = "# Draws the worst error of t by class of difficulty: gnuplot stability.gp\n";
    text += "headline = \"Where the first moment of contact loses its digits\"\n";
    text += fmt::format("subline = \"{}, {} cases, each judged in 200 digits\"\n", scope(pairs),
                        thousands(static_cast<std::int64_t>(cases)));
    text += fmt::format("verdict = \"{}\"\n", verdict(scores));
    text += array("title", titles) + array("quantity", quantities) + array("first", firsts) +
            array("last", lasts);
    std::string plot = std::string(formulas) + in_both_formats("stability", sheet, drawing);
    std::string choose;
    for (std::size_t i = 0; i < tick_commands.size(); ++i)
        choose += fmt::format("        if (k == {}) {{ set xtics ({}) font small offset 0, 0.3 }}\n", i + 1,
                              tick_commands[i]);
    const std::string_view placeholder = "        @ticks\n";
    plot.replace(plot.find(placeholder), placeholder.size(), choose);
    return text + cells(scores, kinds) + plot;
}

} // namespace brink::bench
