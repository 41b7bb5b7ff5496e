// SPDX-License-Identifier: BSD-3-Clause
#include "tunnelling_report.h"

#include "output.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace brink::bench {
namespace {

constexpr std::array decades{0.1, 1.0, 10.0, 100.0, 1000.0};

double percent(int part, int whole) { return 100.0 * part / whole; }

/// "0" only where there is none: a share that would round to it is shown as less than the last digit.
std::string share(int part, int whole)
{
    if (part == 0) return "0";
    if (percent(part, whole) < 0.005) return "<0.01";
    return fmt::format("{:.{}f}", percent(part, whole), percent(part, whole) < 10 ? 2 : 1);
}

void add_scene(fmt::memory_buffer& text, const std::vector<Row>& rows, const Scene& scene)
{
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "\n{}: {} true crossings; speed in units of {}\n", scene.title,
                   thousands(total(rows, scene, methods.back()).crossings), scene.thickness);
    fmt::format_to(out, "  {:<29} {:>36}   {:>8}  {:>7}  {:>10}  {:>9}\n", "",
                   "missed, % of true crossings, at speed", "missed,", "late,", "late by up", "ns per");
    fmt::format_to(out, "  {:<29}  {:>6} {:>6} {:>6} {:>6} {:>6}   {:>8}  {:>7}  {:>10}  {:>9}\n", "method",
                   "0.1", "1", "10", "100", "1000", "% of all", "% of all", "to, steps", "query");
    for (const Method& method : methods) {
        fmt::format_to(out, "  {:<29} ", method.title);
        for (const Row& row : rows) {
            if (row.scene != &scene || row.method != &method) continue;
            const auto is_speed = [&](double decade) { return std::abs(row.speed / decade - 1) < 1e-9; };
            if (std::any_of(decades.begin(), decades.end(), is_speed))
                fmt::format_to(out, " {:>6}", share(row.tally.missed, row.tally.crossings));
        }
        const Tally all = total(rows, scene, method);
        fmt::format_to(out, "   {:>8}  {:>8}  {:>10.1e}  {:>9.0f}\n", share(all.missed, all.crossings),
                       share(all.late, all.crossings), all.latest, all.ns);
    }
}

constexpr Sheet sheet{.svg = {18, 27, 21, 15}, .png = {14, 21, 16, 12}, .lines = "rounded"};

/// What stays the same whatever was measured. Reads tunnelling.csv, scene by scene and method by method;
/// wants the headline and the arrays scene_name, scene_title, scene_unit, verdict, method_name and
/// method_title.
constexpr std::string_view formulas = R"GP(
set datafile separator ','
array colour[6] = ['#D55E00', '#E69F00', '#CC79A7', '#56B4E9', '#0072B2', '#007A5A']
array mark[6] = [7, 5, 9, 4, 6, 0]
array width[6] = [2.5, 2.5, 2.5, 2.5, 2.5, 8]
missed(s, m) = (strcol('scene') eq scene_name[s] && strcol('method') eq method_name[m]) ? column('missed_percent') : NaN
left(s) = 0.08 + 0.315 * (s - 1)
key_x(m) = 0.10 + 0.30 * ((m - 1) % 3)
key_y(m) = m <= 3 ? 0.09 : 0.04
)GP";

constexpr std::string_view drawing = R"GP(
    set multiplot
    set logscale x
    set xrange [0.09:1150]
    set yrange [-15:104]
    set xtics ('0.1' 0.1, '1' 1, '10' 10, '100' 100, '1000' 1000) nomirror
    set ytics 0, 25, 100 nomirror
    set grid xtics ytics linecolor '#dddddd' linewidth 1 linetype 1
    set border 3 linecolor '#555555'
    set tmargin at screen 0.80
    set bmargin at screen 0.28
    unset key
    do for [s = 1:3] {
        set lmargin at screen left(s)
        set rmargin at screen left(s) + 0.27
        set label 1 scene_title[s] at graph 0.5, 1.06 center font middle_size
        set label 2 verdict[s] at 0.13, -8.5 left textcolor rgb colour[6] font middle_size
        set xlabel "distance moved in one step,\nas a multiple of " . scene_unit[s]
        if (s == 1) {
            set label 3 headline at screen 0.5, 0.95 center font large
            set label 4 subline at screen 0.5, 0.895 center font middle_size textcolor rgb '#444444'
            set ylabel 'true crossings missed' offset -0.5, 0
            set ytics format '%g %%'
            do for [m = 1:6] {
                set arrow m from screen key_x(m), key_y(m) to screen key_x(m) + 0.04, key_y(m) nohead \
                    linecolor rgb colour[m] linewidth width[m]
                set label 9 + m method_title[m] at screen key_x(m) + 0.05, key_y(m) left
                set label 19 + m '' at screen key_x(m) + 0.02, key_y(m) point linecolor rgb colour[m] \
                    pointtype mark[m] pointsize 1
            }
        }
        plot for [m = 1:4] 'tunnelling.csv' using 'speed_over_thickness':(missed(s, m)) with linespoints \
                 linecolor rgb colour[m] linewidth width[m] pointtype mark[m] pointsize 0.9, \
             'tunnelling.csv' using 'speed_over_thickness':(missed(s, 6)) with lines \
                 linecolor rgb colour[6] linewidth width[6], \
             'tunnelling.csv' using 'speed_over_thickness':(missed(s, 5)) with linespoints \
                 linecolor rgb colour[5] linewidth width[5] pointtype mark[5] pointsize 0.9
        unset label
        unset arrow
        unset ylabel
        set ytics format ''
    }
    unset multiplot
)GP";

/// A gnuplot array: array name[n] = ["...", "..."]
std::string gnuplot_array(std::string_view name, const std::vector<std::string>& items)
{
    return fmt::format("array {}[{}] = [\"{}\"]\n", name, items.size(), fmt::join(items, "\", \""));
}

} // namespace

Tally total(const std::vector<Row>& rows, const Scene& scene, const Method& method)
{
    Tally sum;
    for (const Row& row : rows) {
        if (row.scene != &scene || row.method != &method) continue;
        sum.ns += row.tally.ns * row.tally.crossings;
        sum.crossings += row.tally.crossings;
        sum.missed += row.tally.missed;
        sum.late += row.tally.late;
        sum.latest = std::max(sum.latest, row.tally.latest);
        sum.earliest = std::max(sum.earliest, row.tally.earliest);
    }
    sum.ns /= std::max(sum.crossings, 1);
    return sum;
}

std::string tunnelling_csv(const std::vector<Row>& rows)
{
    std::string text =
        "scene,method,speed_over_thickness,crossings,missed,missed_percent,late,latest_steps,earliest_steps,"
        "ns_per_query\n";
    for (const Row& row : rows) {
        const Tally& tally = row.tally;
        text += fmt::format("{},{},{:.4g},{},{},{:.4g},{},{:.3g},{:.3g},{:.1f}\n", row.scene->name,
                            row.method->name, row.speed, tally.crossings, tally.missed,
                            percent(tally.missed, tally.crossings), tally.late, tally.latest, tally.earliest,
                            tally.ns);
    }
    return text;
}

std::string tunnelling_table(const std::vector<Row>& rows)
{
    fmt::memory_buffer text;
    for (const Scene& scene : scenes)
        add_scene(text, rows, scene);
    return fmt::to_string(text);
}

std::string tunnelling_plot(const std::vector<Row>& rows)
{
    std::vector<std::string> names, titles, units, verdicts, method_names, method_titles;
    int missed = 0, crossings = 0;
    for (const Scene& scene : scenes) {
        const Tally brink = total(rows, scene, methods.back());
        names.emplace_back(scene.name);
        titles.emplace_back(scene.title);
        units.emplace_back(scene.thickness);
        verdicts.push_back(
            fmt::format("brink missed {} of {}", thousands(brink.missed), thousands(brink.crossings)));
        missed += brink.missed;
        crossings += brink.crossings;
    }
    for (const Method& method : methods) {
        method_names.emplace_back(method.name);
        method_titles.emplace_back(method.title);
    }
    std::string text = "# Draws tunnelling.csv: gnuplot tunnelling.gp\n";
    text += fmt::format("headline = \"Fast bodies slip through thin walls unseen; brink missed {} of {}\"\n",
                        thousands(missed), thousands(crossings));
    text += "subline = \"The share of certain contacts that each method overlooks in one time step\"\n";
    text += gnuplot_array("scene_name", names) + gnuplot_array("scene_title", titles) +
            gnuplot_array("scene_unit", units) + gnuplot_array("verdict", verdicts) +
            gnuplot_array("method_name", method_names) + gnuplot_array("method_title", method_titles);
    return text + std::string(formulas) + in_both_formats("tunnelling", sheet, drawing);
}

} // namespace brink::bench
