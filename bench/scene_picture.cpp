// SPDX-License-Identifier: BSD-3-Clause
#include "output.h"
#include "scene_report.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <set>

namespace brink::bench {
namespace {

constexpr Sheet sheet{.height = 980, .svg = {16, 25, 18, 14}, .png = {12.5, 19, 15, 11}};

/// The panels and everything else but the figures. Wants headline, subline, the array title, least and most
/// (ms), fewest and utmost (bodies), @plot replaced, lines and rings (the curves there are in each order, "0
/// 2"), and $points: panel, curve (0 brink, 1 brink with more threads, 2 FCL, 3 Bullet, 4 the floor), order
/// (0 spatial, 1 random), bodies, ms.
constexpr std::string_view formulas = R"GP(
array colour[5] = ['#0072B2', '#56B4E9', '#D55E00', '#009E73', '#777777']
array named[5] = ['brink', 'brink, two threads', 'FCL', 'Bullet', 'memory bandwidth floor']
array dashes[5] = [1, 1, 1, 1, 3]
array types[5] = [7, 7, 7, 7, 0]
drawn(curves, i) = word(curves, i) + 0
pick(k, curve, order) = column(1) == k && column(2) == curve && column(3) == order ? column(5) : NaN
columns = |title| < 3 ? |title| : 3
rows = ceil(|title| / (1.0 * columns))
)GP";

constexpr std::string_view drawing = R"GP(
    set multiplot
    unset key
    set datafile missing NaN
    set logscale xy
    set xrange [fewest:utmost]
    set yrange [least:most]
    set border 3 linecolor '#555555'
    set tics nomirror
    set grid linecolor '#dddddd' linewidth 1 linetype 1
    set label 1 headline at screen 0.5, 0.968 center font large
    set label 2 subline at screen 0.5, 0.928 center textcolor rgb '#444444' font middle_size
    set label 3 'bodies (logarithmic)' at screen 0.53, 0.03 center
    names = lines . (lines eq '' ? rings : '')
    do for [i = 1:words(names)] {
        c = word(names, i) + 0
        x = 0.085 + 0.175 * c
        if (c == 4) {
            set arrow 1 from screen x, 0.885 to screen x + 0.02, 0.885 nohead linewidth 2 dashtype 3 linecolor rgb colour[5]
        }
        set label (11 + c) named[c + 1] at screen x, 0.885 left offset (c == 4 ? 4.5 : 1.4), 0 \
            point pointtype (c == 4 ? 0 : 7) pointsize 1.4 linecolor rgb colour[c + 1] textcolor rgb colour[c + 1]
    }
    do for [k = 1:|title|] {
        at = (k - 1) % columns
        j = (k - 1) / columns
        high = 0.79 / rows
        set lmargin at screen 0.085 + 0.91 * at / columns
        set rmargin at screen 0.085 + 0.91 * (at + 1) / columns - 0.02
        set tmargin at screen 0.830 - high * j
        set bmargin at screen 0.830 - high * (j + 1) + 0.065
        set label 5 title[k] at graph 0.03, 1 left offset 0, 0.7 font middle_size
        set xtics ('10^3' 1e3, '10^4' 1e4, '10^5' 1e5, '10^6' 1e6) font small
        if (at == 0) {
            set ytics ('0.1 µs' 1e-4, '1 µs' 1e-3, '10 µs' 1e-2, '0.1 ms' 1e-1, '1 ms' 1, '10 ms' 10, '0.1 s' 100, '1 s' 1e3, '10 s' 1e4, '100 s' 1e5) font small
        } else {
            set ytics ('' 1e-4, '' 1e-3, '' 1e-2, '' 1e-1, '' 1, '' 10, '' 100, '' 1e3, '' 1e4, '' 1e5)
        }
        @plot
        unset label
        unset arrow
    }
    unset multiplot
)GP";

constexpr std::string_view with_lines = R"GP($points using 4:(pick(k, drawn(lines, i), 0)) with linespoints \
                 linewidth 3 dashtype dashes[drawn(lines, i) + 1] pointtype types[drawn(lines, i) + 1] \
                 pointsize 0.9 linecolor rgb colour[drawn(lines, i) + 1])GP";
constexpr std::string_view with_rings = R"GP($points using 4:(pick(k, drawn(rings, i), 1)) with points \
                 pointtype 6 pointsize 1.3 linewidth 2 linecolor rgb colour[drawn(rings, i) + 1])GP";

/// gnuplot goes through an empty loop once.
std::string plot_of(const std::array<std::set<int>, 2>& curves)
{
    std::vector<std::string> parts;
    if (!curves[0].empty()) parts.push_back(fmt::format("for [i = 1:words(lines)] {}", with_lines));
    if (!curves[1].empty()) parts.push_back(fmt::format("for [i = 1:words(rings)] {}", with_rings));
    return fmt::format("        plot {}\n", fmt::join(parts, ", \\\n             "));
}

/// Which curve of the picture, -1 for none.
int curve(const SceneFigures& f)
{
    if (f.who == "brink") return f.threads == 1 ? 0 : f.threads == 2 ? 1 : -1;
    return f.who == "FCL" ? 2 : f.who == "Bullet" ? 3 : -1;
}

} // namespace

std::string scenes_plot(const SceneResults& results)
{
    std::vector<std::string> titles;
    std::string rows;
    double least = 1e9, most = 0;
    std::size_t fewest = results.figures.front().n, utmost = fewest;
    std::array<std::set<int>, 2> curves; // that there are, in spatial order and at random
    const auto add = [&](std::size_t panel, int c, const SceneFigures& f, double value) {
        curves[f.order == "spatial" ? 0 : 1].insert(c);
        rows += fmt::format("{} {} {} {} {:.5g}\n", panel, c, f.order == "spatial" ? 0 : 1, f.n, value);
        least = std::min(least, value);
        most = std::max(most, value);
    };
    std::vector<SceneFigures> figures = results.figures; // a curve's points one after the other
    std::stable_sort(figures.begin(), figures.end(),
                     [](const SceneFigures& a, const SceneFigures& b) { return a.n < b.n; });
    for (const SceneFigures& f : figures) {
        if (curve(f) < 0 || f.step_ms <= 0) continue;
        const std::string title = fmt::format("\"{}\"", f.scene);
        auto at = std::find(titles.begin(), titles.end(), title);
        if (at == titles.end()) at = titles.insert(titles.end(), title);
        const auto panel = static_cast<std::size_t>(at - titles.begin()) + 1;
        add(panel, curve(f), f, f.step_ms);
        if (f.who == "brink" && f.threads == 1 && f.order == "spatial") add(panel, 4, f, f.floor_ms);
        fewest = std::min(fewest, f.n);
        utmost = std::max(utmost, f.n);
    }
    std::string text = "# Draws the time of a step over the number of bodies: gnuplot scenes.gp\n";
    text += "headline = 'Everything moves: the tree and all pairs whose swept boxes overlap'\n";
    text += "subline = 'ms of a step (logarithmic), one thread where no more are named; bodies stored in "
            "spatial order (lines) or at "
            "random (rings)'\n";
    text += fmt::format("lines = '{}'\nrings = '{}'\n", fmt::join(curves[0], " "), fmt::join(curves[1], " "));
    text += fmt::format("least = {:.3g}\nmost = {:.3g}\nfewest = {}\nutmost = {}\n", 0.5 * least, 2 * most,
                        0.8 * static_cast<double>(fewest), 1.25 * static_cast<double>(utmost));
    text += fmt::format("array title[{}] = [{}]\n$points << END\n", titles.size(), fmt::join(titles, ", "));
    std::string plot = in_both_formats("scenes", sheet, drawing);
    const std::string_view placeholder = "        @plot\n";
    for (std::size_t at = plot.find(placeholder); at != std::string::npos; at = plot.find(placeholder))
        plot.replace(at, placeholder.size(), plot_of(curves));
    return text + rows + "END\n" + std::string(formulas) + plot;
}

} // namespace brink::bench
