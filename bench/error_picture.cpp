// SPDX-License-Identifier: BSD-3-Clause
#include "error_picture.h"

#include "output.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace brink::bench {
namespace {

constexpr double least_error = 1e-17; // smaller ones are drawn here

/// How a solver is drawn.
struct Look {
    std::string_view who; // ErrorPoint::who
    std::string_view legend;
    std::string_view style; // in gnuplot's words
    std::string_view beside; // where its counts stand
};

constexpr std::array looks{
    Look{"brink", "brink, tolerance 10^{-3} to 10^{-14}",
         "linespoints pointtype 7 linewidth 3 linecolor rgb '#0050d0'", ""},
    Look{"FCL conservative advancement", "FCL conservative advancement",
         "points pointtype 5 linecolor rgb '#d55e00'", "left offset 0.7, 0"},
    Look{"FCL naive", "FCL naive, 10 to 1,000 poses",
         "linespoints pointtype 9 linewidth 1 dashtype 3 linecolor rgb '#e0a000'", "right offset -0.7, 0"},
    Look{"FCL discrete", "FCL discrete, 1 to 1,000 substeps",
         "linespoints pointtype 4 linewidth 1 dashtype 3 linecolor rgb '#707070'", "left offset 0.7, 0"},
    Look{"Bullet btSubsimplexConvexCast", "Bullet btSubsimplexConvexCast",
         "linespoints pointtype 13 linewidth 1 dashtype 3 linecolor rgb '#009e73'", "right offset -0.7, 0"},
    Look{"Bullet btGjkConvexCast", "Bullet btGjkConvexCast", "points pointtype 11 linecolor rgb '#7a3db8'",
         "left offset 0.7, -0.6"},
    Look{"Bullet btContinuousConvexCollision", "Bullet btContinuousConvexCollision",
         "linespoints pointtype 15 linewidth 1 dashtype 3 linecolor rgb '#c2185b'", "left offset 0.7, 0"}};

std::string counts(const ErrorPoint& p)
{
    if (p.is_brink() || (p.missed == 0 && p.false_hits == 0 && p.late == 0)) return "";
    return fmt::format("{}/{}/{}", p.missed, p.false_hits, p.late);
}

std::string block_name(std::size_t panel, std::size_t look) { return fmt::format("$points_{}_{}", panel, look); }

/// A panel's figures, a block for every solver that has any.
struct Series {
    std::string blocks;
    std::vector<std::size_t> looks; // of those solvers
};

Series series(const ErrorPoints& points, std::size_t panel)
{
    Series out;
    for (std::size_t k = 0; k < looks.size(); ++k) {
        std::string rows;
        for (const ErrorPoint& p : points)
            if (p.who == looks[k].who && !std::isnan(p.p50))
                rows += fmt::format("{:.3e} {:.2f} \"{}\"\n", std::max(p.p50, least_error), p.ns, counts(p));
        if (rows.empty()) continue;
        out.blocks += fmt::format("{} << END\n{}END\n", block_name(panel, k), rows);
        out.looks.push_back(k);
    }
    return out;
}

/// Rivals first, so that brink's curve lies on top.
std::string plot(std::size_t panel, const std::vector<std::size_t>& present, double size)
{
    std::vector<std::string> clauses;
    for (std::size_t i = present.size(); i-- > 0;) {
        const Look& look = looks[present[i]];
        const std::string block = block_name(panel, present[i]);
        clauses.push_back(fmt::format("{} using 1:2 with {} pointsize {}", block, look.style,
                                      present[i] == 0 ? 0.7 * size : size));
        if (!look.beside.empty())
            clauses.push_back(
                fmt::format("{} using 1:2:3 with labels {} font small", block, look.beside));
    }
    return fmt::format("    plot {}\n", fmt::join(clauses, ", \\\n         "));
}

struct Range {
    double least, most; // ns
};

Range times(const ErrorPoints& points)
{
    Range out{1e9, 1};
    for (const ErrorPoint& p : points) {
        out.least = std::min(out.least, p.ns);
        out.most = std::max(out.most, p.ns);
    }
    return {std::pow(10, std::floor(std::log10(out.least))), out.most * 2};
}

constexpr std::string_view axes = R"GP(    set logscale xy
    set border 3 linecolor '#555555'
    set tics nomirror
    set grid linecolor '#dddddd' linewidth 1 linetype 1
    unset key
)GP";

/// Tics with their names, and without.
constexpr std::string_view times_named = "('10 ns' 10, '100 ns' 100, '1 µs' 1e3, '10 µs' 1e4, '100 µs' 1e5, '1 ms' 1e6)";
constexpr std::string_view times_bare = "('' 10, '' 100, '' 1e3, '' 1e4, '' 1e5, '' 1e6)";
constexpr std::string_view errors_named =
    "('10^{-16}' 1e-16, '10^{-12}' 1e-12, '10^{-8}' 1e-8, '10^{-4}' 1e-4, '1' 1)";
constexpr std::string_view errors_bare = "('' 1e-16, '' 1e-12, '' 1e-8, '' 1e-4, '' 1)";

/// Where a panel lies, in pixels from the left and the top.
struct Frame {
    double left, right, top, bottom;
};

std::string margins(const Frame& f, int height)
{
    return fmt::format("    set lmargin at screen {:.4f}; set rmargin at screen {:.4f}\n"
                       "    set tmargin at screen {:.4f}; set bmargin at screen {:.4f}\n",
                       f.left / 1500, f.right / 1500, 1 - f.top / height, 1 - f.bottom / height);
}

/// The names of all solvers that the page shows, in rows of so many.
std::string legend(const ErrorPoints& points, const Frame& within, int per_row, double size, int height)
{
    std::string text;
    int place = 0;
    for (const Look& look : looks) {
        const auto shown = [&](const ErrorPoint& p) { return p.who == look.who; };
        if (std::none_of(points.begin(), points.end(), shown)) continue;
        const double wide = (within.right - within.left) / per_row;
        const double x = within.left + wide * (place % per_row);
        const double y = within.top + 34.0 * (place / per_row);
        const std::string_view mark = look.style.substr(look.style.find("pointtype"));
        const std::string plain(mark.substr(0, mark.find(" linewidth")));
        const std::string_view colour = look.style.substr(look.style.find("linecolor"));
        text += fmt::format("    set label {} '{}' at screen {:.4f}, {:.4f} left point {} {} pointsize {} offset "
                            "1.2, 0 font middle_size\n",
                            100 + place, look.legend, x / 1500, 1 - y / height,
                            plain.substr(0, plain.find(" linecolor")), colour, size);
        ++place;
    }
    return text;
}

std::string heading(std::string_view headline, std::string_view note, int height)
{
    return fmt::format("    set label 90 '{}' at screen 0.5, {:.4f} center font large\n"
                       "    set label 91 '{}' at screen 0.5, {:.4f} center font middle_size\n",
                       headline, 1 - 34.0 / height, note, 1 - 74.0 / height);
}

std::string note(const ErrorPoints& points)
{
    const ErrorPoint& p = points.front();
    return fmt::format("beside a rival’s mark: hits missed / false hits / hits said too late, of {} hits and {} "
                       "misses; nothing where there are none",
                       p.hits, p.queries - p.hits);
}

} // namespace

std::string error_page(const ErrorPoints& points, std::string_view stem, std::string_view headline)
{
    constexpr std::size_t columns = 5;
    constexpr double top = 190;
    constexpr double row_height = 262;
    const std::vector<ErrorPoints> questions = by_question(points);
    const std::size_t rows = (questions.size() + columns - 1) / columns;
    const int height = static_cast<int>(top + row_height * static_cast<double>(rows)) + 70;
    const Range range = times(points);
    std::string blocks;
    std::string drawing = "    set multiplot\n" + std::string(axes);
    drawing += fmt::format("    set xrange [1e-17:1e4]\n    set yrange [{:.3g}:{:.3g}]\n", range.least, range.most);
    drawing += heading(headline, note(points), height);
    drawing += legend(points, {70, 1480, 112, 0}, 4, 1.5, height);
    drawing += fmt::format("    set label 92 'error of t, in steps (median over the hits seen); both axes are "
                           "logarithmic: left is more exact, lower is faster' at screen 0.5, {:.4f} center "
                           "font middle_size\n",
                           18.0 / height);
    for (std::size_t k = 0; k < questions.size(); ++k) {
        const Series shown = series(questions[k], k);
        blocks += shown.blocks;
        const double x = 80 + 284.0 * static_cast<double>(k % columns);
        const double y = top + row_height * static_cast<double>(k / columns);
        drawing += margins({x, x + 270, y + 26, y + 228}, height);
        drawing += fmt::format("    set label 1 '{}' at graph 0.5, 1.07 center font middle_size noenhanced\n",
                               questions[k].front().pair);
        drawing += fmt::format("    set ytics {} font small\n    set xtics {} font small\n",
                               k % columns == 0 ? times_named : times_bare,
                               k + columns >= questions.size() ? errors_named : errors_bare);
        drawing += plot(k, shown.looks, 1.1);
        drawing += "    unset label\n";
    }
    drawing += "    unset multiplot\n";
    const Sheet sheet{.height = height, .svg = {15, 24, 16, 10}, .png = {12, 19, 13, 8}};
    return fmt::format("# Draws time per query over error of t: gnuplot {}.gp\n", stem) + blocks +
           in_both_formats(stem, sheet, drawing);
}

std::string error_sheet(const ErrorPoints& points, std::string_view stem, std::string_view headline)
{
    constexpr int height = 1000;
    const Range range = times(points);
    const Series shown = series(points, 0);
    std::string drawing = std::string(axes);
    drawing += fmt::format("    set xrange [1e-17:30]\n    set yrange [{:.3g}:{:.3g}]\n", range.least, range.most);
    drawing += heading(headline, note(points), height);
    drawing += legend(points, {130, 1480, 112, 0}, 3, 2.2, height);
    drawing += margins({130, 1480, 230, 900}, height);
    drawing += fmt::format("    set ytics {} font middle_size\n    set xtics {} font middle_size\n", times_named,
                           errors_named);
    drawing += "    set ylabel 'time per query'\n    set xlabel 'error of t, in steps (median over the hits seen)'\n";
    drawing += plot(0, shown.looks, 2);
    const Sheet sheet{.height = height, .svg = {22, 32, 22, 18}, .png = {17, 25, 17, 14}};
    return fmt::format("# Draws time per query over error of t: gnuplot {}.gp\n", stem) + shown.blocks +
           in_both_formats(stem, sheet, drawing);
}

} // namespace brink::bench
