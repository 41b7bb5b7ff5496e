// SPDX-License-Identifier: BSD-3-Clause
#include "turning_picture.h"

#include "output.h"
#include "turning_report.h"

#include <stress_turning.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace brink::bench {
namespace {

constexpr double least = 1e-4; // smaller shares are drawn here,
constexpr double most = 1e9;   // and larger ones here

constexpr Sheet sheet{.height = 960, .svg = {15, 25, 18, 13}, .png = {11.5, 19, 14, 10}};

/// Wants headline, subline, the arrays title, quantity, brink_says, fcl_says, level_from, level_to, and
/// $cells: panel, solver (0 brink, 1 FCL), level from, to, median and most of the allowance used (0: no
/// hits), wrong or late ones; @ticks is replaced by the axis of panel k.
constexpr std::string_view formulas = R"GP(
array colour[2] = ['#0072B2', '#D55E00']
columns = 5
mine(k, who) = column(1) == k && column(2) == who
seen(k, who) = mine(k, who) && column(6) > 0
centre(who) = column(3) + (column(4) - column(3)) * (who == 0 ? 0.3 : 0.7)
)GP";

constexpr std::string_view drawing = R"GP(
    set multiplot
    unset key
    set logscale y
    set yrange [3e-5:1e13]
    set border 3 linecolor '#555555'
    set tics nomirror
    set grid ytics linecolor '#e4e4e4' linewidth 1 linetype 1
    do for [k = 1:|title|] {
        i = (k - 1) % columns
        j = (k - 1) / columns
        set lmargin at screen 0.075 + 0.185 * i
        set rmargin at screen 0.075 + 0.185 * i + 0.168
        set tmargin at screen 0.80 - 0.395 * j
        set bmargin at screen 0.80 - 0.395 * j - 0.27
        set xrange [level_from[k]:level_to[k]]
        set ytics ('10^{-4}' 1e-4, '10^{-2}' 1e-2, '1' 1, '10^{2}' 1e2, '10^{4}' 1e4, '10^{6}' 1e6, '10^{8}' 1e8) font small
        if (i > 0) { set ytics ('' 1e-4, '' 1e-2, '' 1, '' 1e2, '' 1e4, '' 1e6, '' 1e8) }
        if (i == 0) { set ylabel "gap left at t, over\nwhat promise 3 allows" offset 0.5, 0 } else { unset ylabel }
        @ticks
        set label 1 title[k] at graph 0, 1.20 left font middle_size
        set label 2 brink_says[k] at graph 0, 1.11 left textcolor rgb colour[1] font small
        set label 3 fcl_says[k] at graph 0, 1.035 left textcolor rgb colour[2] font small
        set object 1 rectangle from level_from[k], 3e-5 to level_to[k], 1 fillcolor rgb '#e3f1e3' fillstyle solid 1 noborder behind
        set arrow 1 from level_from[k], 1 to level_to[k], 1 nohead linecolor rgb '#2a7a2a' linewidth 2 front
        if (k == 1) {
            set label 9 'allowed' at graph 0.98, first 1.2e-4 right textcolor rgb '#2a7a2a' font small
            set label 4 headline at screen 0.5, 0.965 center font large
            set label 5 subline at screen 0.5, 0.922 center textcolor rgb '#444444' font middle_size
            set label 6 'brink, from the median hit up to the worst' at screen 0.08, 0.028 left point pointtype 7 pointsize 1.2 linecolor rgb colour[1] offset 1.2, 0
            set label 7 'FCL conservative advancement, likewise (which promises no such thing)' at screen 0.34, 0.028 left point pointtype 5 pointsize 1.2 linecolor rgb colour[2] offset 1.2, 0
            set label 8 '× at the top: wrong or late answers' at screen 0.76, 0.028 left
        }
        set xlabel quantity[k] font small offset 0, 0.5
        plot for [w = 0:1] $cells using (seen(k, w) ? centre(w) : NaN):5:5:6:6 with candlesticks \
                 linecolor rgb colour[w + 1] linewidth 4, \
             for [w = 0:1] $cells using (seen(k, w) ? centre(w) : NaN):6 with points pointtype (w == 0 ? 7 : 5) \
                 pointsize 1 linecolor rgb colour[w + 1], \
             for [w = 0:1] $cells using (mine(k, w) && column(7) > 0 ? centre(w) : NaN):(w == 0 ? 1.5e12 : 4e10):('×') \
                 with labels textcolor rgb colour[w + 1] font middle_size
        unset label
        unset object
        unset arrow
    }
    unset multiplot
)GP";

constexpr std::array<std::string_view, support::turning_classes.size()> titles{
    "turning",        "rocking next to it", "a pivot far off",     "needles",  "far from the origin",
    "from far apart", "from tiny to huge",  "passing by a little", "touching", "at any tolerance"};

double drawn(const std::vector<double>& used, double share)
{
    return used.empty() ? 0 : std::clamp(Score::at_share(used, share), least, most);
}

std::string cells(const Scores& scores, const std::set<std::size_t>& kinds)
{
    std::string text = "$cells << END\n";
    std::size_t panel = 0;
    for (const std::size_t kind : kinds) {
        const support::TurningClass& c = support::turning_classes[kind];
        ++panel;
        for (std::size_t step = 0; c.first + static_cast<double>(step) * c.decades < c.last; ++step) {
            const double from = c.first + static_cast<double>(step) * c.decades;
            for (const Solver solver : {Solver::brink, Solver::fcl}) {
                const Score s = pooled(scores, solver,
                                       [](const Spot& spot, const Spot& wanted) {
                                           return spot.kind == wanted.kind && spot.step == wanted.step;
                                       },
                                       {0, kind, step});
                text += fmt::format("{} {} {:g} {:g} {:.3e} {:.3e} {}\n", panel,
                                    solver == Solver::fcl ? 1 : 0, from, from + c.decades, drawn(s.used, 0.5),
                                    drawn(s.used, 1), s.wrong + s.late);
            }
        }
    }
    return text + "END\n";
}

/// At powers of ten with room between them; "0" at the step that holds exact zeros.
std::string ticks(const support::TurningClass& c)
{
    const bool zero =
        c.stress == support::TurningStress::angle || c.stress == support::TurningStress::touching;
    const double span = c.last - c.first;
    const double every = span > 100 ? 50 : span > 8 ? 4 : 2;
    std::string text = zero ? fmt::format("'0' {}", c.first + 0.5) : "";
    for (double at = std::ceil((c.first + (zero ? 2 : 0)) / every) * every; at < c.last; at += every)
        text += fmt::format("{}'10^{{{:g}}}' {:g}", text.empty() ? "" : ", ", at, at);
    return text;
}

std::string percent(std::uint64_t part, std::uint64_t whole)
{
    if (part == 0 || whole == 0) return "0";
    return fmt::format("{:.1f}", 100 * static_cast<double>(part) / static_cast<double>(whole));
}

std::string brink_says(const Score& s)
{
    return fmt::format("brink: {} wrong, {} late, {} undecided", s.wrong, s.late, s.undecided);
}

std::string fcl_says(const Score& s)
{
    return fmt::format("FCL, %: {} wrong, {} late, {} hung", percent(s.wrong, s.cases),
                       percent(s.late, s.cases), percent(s.undecided, s.cases));
}

std::string array(std::string_view name, const std::vector<std::string>& items)
{
    return fmt::format("array {}[{}] = [{}]\n", name, items.size(), fmt::join(items, ", "));
}

std::string in_quotes(std::string_view text) { return fmt::format("\"{}\"", text); }

/// The arrays of the panels.
std::string panels(const Scores& scores, const std::set<std::size_t>& kinds)
{
    std::vector<std::string> names, quantities, brink, fcl, firsts, lasts;
    for (const std::size_t kind : kinds) {
        const support::TurningClass& c = support::turning_classes[kind];
        const auto of_kind = [](const Spot& spot, const Spot& wanted) { return spot.kind == wanted.kind; };
        names.push_back(in_quotes(titles[kind]));
        quantities.push_back(in_quotes(c.quantity));
        brink.push_back(in_quotes(brink_says(pooled(scores, Solver::brink, of_kind, {0, kind, 0}))));
        fcl.push_back(in_quotes(fcl_says(pooled(scores, Solver::fcl, of_kind, {0, kind, 0}))));
        firsts.push_back(fmt::format("{:g}", c.first));
        lasts.push_back(fmt::format("{:g}", c.last));
    }
    return array("title", names) + array("quantity", quantities) + array("brink_says", brink) +
           array("fcl_says", fcl) + array("level_from", firsts) + array("level_to", lasts);
}

} // namespace

std::string turning_plot(const Scores& scores)
{
    std::set<std::size_t> kinds, pairs;
    for (const auto& [spot, unused] : scores.at) {
        kinds.insert(spot.kind);
        pairs.insert(spot.pair);
    }
    const Score brink = pooled(scores, Solver::brink, [](const Spot&, const Spot&) { return true; }, {});
    std::string text = "# Draws what answers use of promise 3's allowance: gnuplot turning.gp\n";
    const auto count = [](std::uint64_t n) { return thousands(static_cast<std::int64_t>(n)); };
    text += fmt::format("headline = \"Bodies that turn, as hard as can be: of {} queries brink answers {} "
                        "wrong and {} late\"\n",
                        count(brink.cases), count(brink.wrong), count(brink.late));
    text += fmt::format("subline = \"{}, each query judged in 100 digits; the worst gap that brink leaves is "
                        "{:.4f} of what it may; answers that break any promise: {}\"\n",
                        pairs.size() == 1 ? "1 pair" : fmt::format("{} pairs", pairs.size()),
                        Score::at_share(brink.used, 1), brink.broken);
    std::string plot = std::string(formulas) + in_both_formats("turning", sheet, drawing);
    std::string choose;
    std::size_t panel = 0;
    for (const std::size_t kind : kinds)
        choose += fmt::format("        if (k == {}) {{ set xtics ({}) font small offset 0, 0.3 }}\n", ++panel,
                              ticks(support::turning_classes[kind]));
    const std::string_view placeholder = "        @ticks\n";
    plot.replace(plot.find(placeholder), placeholder.size(), choose);
    return text + panels(scores, kinds) + cells(scores, kinds) + plot;
}

} // namespace brink::bench
