// SPDX-License-Identifier: BSD-3-Clause
#include "tunnelling_picture.h"

#include "output.h"

#include <fmt/format.h>

namespace brink::bench {
namespace {

constexpr Sheet sheet{.height = 1330, .svg = {17, 27, 20, 15}, .png = {13, 21, 15, 11}, .lines = "rounded"};

/// What stays the same whatever was measured. Reads tunnelling.csv, scene by scene and method by method;
/// wants headline, subline, the arrays scene_name, scene_title, scene_unit, verdict, method_name and
/// method_title, and $cost: method (from 1), its line there, nanoseconds, whether something turns.
constexpr std::string_view formulas = R"GP(
set datafile separator ','
array colour[6] = ['#D55E00', '#E69F00', '#CC79A7', '#56B4E9', '#0072B2', '#007A5A']
array mark[6] = [7, 5, 9, 4, 6, 13]
array width[6] = [2.5, 2.5, 2.5, 2.5, 2.5, 6]
array order[6] = [1, 2, 3, 4, 6, 5]
is(s, m) = strcol('scene') eq scene_name[s] && strcol('method') eq method_name[m]
missed(s, m) = is(s, m) ? column('missed_percent') : NaN
left(s) = 0.075 + 0.315 * ((s - 1) % 3)
top(s) = s <= 3 ? 0.875 : 0.565
)GP";

constexpr std::string_view shares = R"GP(
    set multiplot
    set logscale x
    set xrange [0.085:1200]
    set yrange [-4:104]
    set xtics ('0.1' 0.1, '1' 1, '10' 10, '100' 100, '1000' 1000) nomirror
    set grid xtics ytics linecolor '#dddddd' linewidth 1 linetype 1
    set border 3 linecolor '#555555'
    unset key
    do for [s = 1:6] {
        set lmargin at screen left(s)
        set rmargin at screen left(s) + 0.28
        set tmargin at screen top(s)
        set bmargin at screen top(s) - 0.205
        set label 1 scene_title[s] at graph 0, 1.10 left font middle_size
        set label 2 verdict[s] at graph 0, 1.03 left textcolor rgb colour[6] font small
        set xlabel 'speed, in units of ' . scene_unit[s] . ' a step' offset 0, 0.3 font small
        set ytics 0, 25, 100 nomirror format (s % 3 == 1 ? '%g %%' : '')
        if (s == 1) {
            set label 3 headline at screen 0.5, 0.972 center font large
            set label 4 subline at screen 0.5, 0.943 center font middle_size textcolor rgb '#444444'
        }
        plot for [i = 1:6] m = order[i] 'tunnelling.csv' using 'speed_over_thickness':(missed(s, m)) \
                 with lines linecolor rgb colour[m] linewidth width[m], \
             for [i = 1:6] m = order[i] 'tunnelling.csv' using 'speed_over_thickness':(missed(s, m)): \
                 'missed_low_percent':'missed_high_percent' with yerrorbars \
                 linecolor rgb colour[m] linewidth 1.5 pointtype mark[m] pointsize 0.9
        unset label
    }
)GP";

constexpr std::string_view costs = R"GP(
    set lmargin at screen 0.285
    set rmargin at screen 0.955
    set tmargin at screen 0.235
    set bmargin at screen 0.068
    set xrange [30:3e5]
    set yrange [0.4:6.6]
    set xtics ('100 ns' 100, '1 µs' 1e3, '10 µs' 1e4, '100 µs' 1e5) nomirror
    set xlabel 'cost of one step: processor time, mean over all speeds (logarithmic; left is cheaper)' offset 0, 0.2
    unset ytics
    set label 1 'filled: bodies that only translate      open: bodies that turn' at graph 1, 1.08 right
    set label 2 'the methods, and what a step of each scene costs' at screen 0.03, graph 1.08 left font middle_size
    do for [m = 1:6] {
        set label 10 + m method_title[m] at screen 0.265, first 7 - m right textcolor rgb colour[m]
        set arrow 10 + m from graph 0, first 7 - m to graph 1, first 7 - m nohead linecolor '#dddddd' back
        set label 20 + m '' at screen 0.274, first 7 - m point linecolor rgb colour[m] pointtype mark[m] pointsize 1.2
    }
    plot for [m = 1:6] $cost using ($1 == m && $4 == 0 ? $3 : NaN):2 with points \
             linecolor rgb colour[m] pointtype 7 pointsize 1.6, \
         for [m = 1:6] $cost using ($1 == m && $4 == 1 ? $3 : NaN):2 with points \
             linecolor rgb colour[m] pointtype 6 pointsize 1.8 linewidth 2.5
    unset label
    unset arrow
    unset multiplot
)GP";

/// A gnuplot array: array name[n] = ["...", "..."]
std::string gnuplot_array(std::string_view name, const std::vector<std::string>& items)
{
    return fmt::format("array {}[{}] = [\"{}\"]\n", name, items.size(), fmt::join(items, "\", \""));
}

std::string cost_lines(const std::vector<Row>& rows)
{
    std::string text = "$cost << END\n";
    for (std::size_t m = 0; m < methods.size(); ++m)
        for (std::size_t s = 0; s < scenes.size(); ++s)
            text += fmt::format("{},{},{:.1f},{}\n", m + 1, methods.size() - m,
                                total(rows, scenes[s], methods[m]).ns, s < translating_scenes ? 0 : 1);
    return text + "END\n";
}

std::string headlines(int missed, int crossings)
{
    return fmt::format(
        "headline = \"Fast bodies slip through thin walls unseen; brink missed {} of {}\"\n"
        "subline = \"The share of certain contacts that each method overlooks in one time step; bars: 95 % "
        "confidence (brink: below {:.4f} %)\"\n",
        thousands(missed), thousands(crossings), confidence(missed, crossings).high);
}

} // namespace

std::string tunnelling_plot(const std::vector<Row>& rows)
{
    std::vector<std::string> names, titles, units, verdicts, method_names, method_titles;
    int missed = 0, crossings = 0;
    for (const Scene& scene : scenes) {
        const Tally brink = total(rows, scene, methods.back());
        names.emplace_back(scene.name);
        titles.emplace_back(scene.title);
        units.emplace_back(scene.thickness);
        verdicts.push_back(fmt::format("brink missed {}, FCL advancement {}, of {}", thousands(brink.missed),
                                       thousands(total(rows, scene, methods[4]).missed),
                                       thousands(brink.crossings)));
        missed += brink.missed;
        crossings += brink.crossings;
    }
    for (const Method& method : methods) {
        method_names.emplace_back(method.name);
        method_titles.emplace_back(method.title);
    }
    std::string text = "# Draws tunnelling.csv: gnuplot tunnelling.gp\n" + headlines(missed, crossings);
    text += gnuplot_array("scene_name", names) + gnuplot_array("scene_title", titles) +
            gnuplot_array("scene_unit", units) + gnuplot_array("verdict", verdicts) +
            gnuplot_array("method_name", method_names) + gnuplot_array("method_title", method_titles) +
            cost_lines(rows);
    const std::string drawing = std::string(shares) + std::string(costs);
    return text + std::string(formulas) + in_both_formats("tunnelling", sheet, drawing);
}

} // namespace brink::bench
