// SPDX-License-Identifier: BSD-3-Clause
#include "error_point.h"
#include "output.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brink::bench {
namespace {

constexpr double least_error = 1e-15; // smaller ones are drawn here

constexpr Sheet sheet{.svg = {18, 25, 21, 15}, .png = {14, 19, 16, 12}};

/// The panels and everything else but the figures. Wants $points: panel, solver (0 brink, 1 FCL), tolerance,
/// ns, median and maximum of the error of t; the array title; least and most (ns).
constexpr std::string_view formulas = R"GP(
array colour[2] = ['#0072B2', '#D55E00']
pick(k, who, x) = column(1) == k && column(2) == who ? column(x) : NaN
named(k) = column(1) == k && column(2) == 0 && (column(3) == 1e-3 || column(3) == 1e-6 || column(3) == 1e-9 || column(3) == 1e-12)
)GP";

constexpr std::string_view drawing = R"GP(
    set multiplot
    unset key
    set label 1 headline at screen 0.5, 0.955 center font large
    set label 2 'error of t (fractions of the step, logarithmic; left is better)' at screen 0.53, 0.045 center
    set logscale xy
    set xrange [1e-15:1e-1]
    set yrange [least:most]
    set border 3 linecolor '#555555'
    set tics nomirror
    set grid linecolor '#dddddd' linewidth 1 linetype 1
    set xtics ('10^{-15}' 1e-15, '10^{-12}' 1e-12, '10^{-9}' 1e-9, '10^{-6}' 1e-6, '10^{-3}' 1e-3) font small
    panels = |title|
    do for [k = 1:panels] {
        set lmargin at screen 0.09 + 0.90 * (k - 1) / panels
        set rmargin at screen 0.09 + 0.90 * k / panels - 0.025
        set tmargin at screen 0.75
        set bmargin at screen 0.14
        set label 3 title[k] at graph 0.5, 1.05 center font middle_size
        if (k == 1) {
            set ytics ('100 ns' 100, '200' 200, '500' 500, '1 µs' 1000, '2 µs' 2000, '5 µs' 5000, '10 µs' 10000, '20 µs' 20000, '50 µs' 50000, '100 µs' 100000) font small
            set ylabel 'mean time per hit (logarithmic)' offset -1, 0
            set label 4 'brink, median hit' at screen 0.12, 0.875 left point pointtype 7 pointsize 1.2 linecolor rgb colour[1] offset 1.2, -0.2
            set label 5 'brink, worst hit' at screen 0.32, 0.875 left point pointtype 6 pointsize 1.2 linewidth 2 linecolor rgb colour[1] offset 1.2, -0.2
            set label 6 'FCL advancement, median hit' at screen 0.51, 0.875 left point pointtype 5 pointsize 1.8 linecolor rgb colour[2] offset 1.2, -0.2
            set label 7 'FCL, worst hit' at screen 0.81, 0.875 left point pointtype 4 pointsize 1.8 linewidth 3 linecolor rgb colour[2] offset 1.2, -0.2
        } else {
            set ytics ('' 100, '' 200, '' 500, '' 1000, '' 2000, '' 5000, '' 10000, '' 20000, '' 50000, '' 100000)
            unset ylabel
        }
        plot $points using (pick(k, 0, 5)):4 with linespoints linewidth 3 pointtype 7 pointsize 1.2 \
                 linecolor rgb colour[1], \
             $points using (pick(k, 0, 6)):4 with linespoints linewidth 2 dashtype 2 pointtype 6 pointsize 1.2 \
                 linecolor rgb colour[1], \
             $points using (pick(k, 1, 5)):4 with points pointtype 5 pointsize 1.8 linewidth 2 \
                 linecolor rgb colour[2], \
             $points using (pick(k, 1, 6)):4 with points pointtype 4 pointsize 1.8 linewidth 3 \
                 linecolor rgb colour[2], \
             $points using (named(k) ? column(6) : NaN):4:(sprintf('10^{%.0f}', log10(column(3)))) with labels \
                 offset 0, 0.9 textcolor rgb colour[1]
        unset label
    }
    unset multiplot
)GP";

} // namespace

std::string error_plot(const std::vector<ErrorPoint>& points)
{
    std::vector<std::string> titles;
    std::string rows;
    double least = 1e9;
    double most = 0;
    for (const ErrorPoint& p : points) {
        const std::string title = fmt::format("\"{}\"", p.pair);
        if (titles.empty() || titles.back() != title) titles.push_back(title);
        rows += fmt::format("{} {} {:g} {:.2f} {:.3e} {:.3e}\n", titles.size(), p.who == "brink" ? 0 : 1,
                            p.tolerance, p.ns, std::max(p.p50, least_error), std::max(p.most, least_error));
        least = std::min(least, p.ns);
        most = std::max(most, p.ns);
    }
    std::string text = "# Draws run time over error of t: gnuplot error.gp\n";
    text += "headline = 'What accuracy costs: two bodies that turn by up to 60 degrees (in blue: "
            "brink’s tolerance)'\n";
    text += fmt::format("least = {:.0f}\nmost = {:.0f}\n", 0.7 * least, 1.8 * most);
    text += fmt::format("array title[{}] = [{}]\n$points << END\n", titles.size(), fmt::join(titles, ", "));
    return text + rows + "END\n" + std::string(formulas) + in_both_formats("error", sheet, drawing);
}

} // namespace brink::bench
