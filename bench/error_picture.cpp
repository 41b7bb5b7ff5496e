// SPDX-License-Identifier: BSD-3-Clause
#include "error_picture.h"

#include "error_labels.h"
#include "output.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace brink::bench {
namespace {

constexpr double page_width = 1500;
constexpr double least_error = 1e-17; // smaller ones are drawn here
constexpr double most_error = 10;     // leaves room for what is written beside marks

/// How a solver is drawn, in gnuplot's words.
struct Look {
    std::string_view who; // ErrorPoint::who
    std::string_view legend;
    int mark;
    std::string_view colour;
};

constexpr std::array looks{
    Look{"brink", "brink, tolerance 10^{-3} to 10^{-14}", 7, "#0050d0"},
    Look{"FCL conservative advancement", "FCL conservative advancement", 5, "#c84a00"},
    Look{"FCL naive", "FCL naive, 10 to 1,000 poses", 9, "#b8860b"},
    Look{"FCL discrete", "FCL discrete, 1 to 1,000 substeps", 4, "#606060"},
    Look{"Bullet btSubsimplexConvexCast", "Bullet btSubsimplexConvexCast", 13, "#00805c"},
    Look{"Bullet btGjkConvexCast", "Bullet btGjkConvexCast", 11, "#7a3db8"},
    Look{"Bullet btContinuousConvexCollision", "Bullet btContinuousConvexCollision", 15, "#c2185b"}};

std::string counts(const ErrorPoint& p)
{
    if (p.is_brink()) return "";
    std::string text;
    const auto add = [&](int count, char what) {
        if (count > 0) text += fmt::format("{}{}{}", text.empty() ? "" : " ", count, what);
    };
    add(p.missed, 'M');
    add(p.false_hits, 'F');
    add(p.late, 'L');
    return text;
}

/// Where a panel lies, in pixels from the left and the top, and the times that it shows, ns.
struct Frame {
    double left, right, top, bottom;
    double least, most;

    double width() const { return right - left; }
    double height() const { return bottom - top; }
    double x_of(double error) const
    {
        const double all = std::log(most_error / least_error);
        return width() * std::log(std::max(error, least_error) / least_error) / all;
    }
    double y_of(double ns) const { return height() * std::log(ns / least) / std::log(most / least); }
    double error_at(double x) const { return least_error * std::pow(most_error / least_error, x / width()); }
    double ns_at(double y) const { return least * std::pow(most / least, y / height()); }
};

/// What a page is drawn with: its height, in pixels, and the sizes of a mark and of the letters beside it.
struct Page {
    int height;
    double mark, letter_width, letter_height;
};

/// The figures of a panel, and the commands that plot them.
struct Panel {
    std::string blocks, plot;
};

Panel panel(const ErrorPoints& points, const Frame& frame, const Page& page, std::size_t number)
{
    std::vector<Spot> marks;
    for (const ErrorPoint& p : points)
        marks.push_back({frame.x_of(std::isnan(p.p50) ? most_error : p.p50), frame.y_of(p.ns), counts(p)});
    const std::vector<Spot> labels =
        placed_labels(marks, {frame.width(), frame.height(), page.letter_width, page.letter_height});
    Panel out;
    std::vector<std::string> clauses;
    for (std::size_t k = looks.size(); k-- > 0;) { // rivals first, so that brink's curve lies on top
        const Look& look = looks[k];
        std::string rows;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (points[i].who != look.who || std::isnan(points[i].p50)) continue;
            rows += fmt::format("{:.3e} {:.2f} {:.3e} {:.2f} \"{}\"\n", std::max(points[i].p50, least_error),
                                points[i].ns, frame.error_at(labels[i].x), frame.ns_at(labels[i].y),
                                labels[i].text);
        }
        if (rows.empty()) continue;
        const std::string block = fmt::format("$points_{}_{}", number, k);
        out.blocks += fmt::format("{} << END\n{}END\n", block, rows);
        clauses.push_back(fmt::format("{} using 1:2 with linespoints pointtype {} pointsize {} linewidth {} "
                                      "dashtype {} linecolor rgb '{}'",
                                      block, look.mark, k == 0 ? 0.75 * page.mark : page.mark, k == 0 ? 3 : 1,
                                      k == 0 ? 1 : 3, look.colour));
        if (k > 0)
            clauses.push_back(fmt::format("{} using 3:4:5 with labels center font small textcolor rgb '{}'",
                                          block, look.colour));
    }
    out.plot = fmt::format("    plot {}\n", fmt::join(clauses, ", \\\n         "));
    return out;
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
    return {out.least / 2, out.most * 2};
}

constexpr std::string_view axes = R"GP(    set logscale xy
    set border 3 linecolor '#555555'
    set tics nomirror
    set grid linecolor '#dddddd' linewidth 1 linetype 1
    unset key
)GP";

/// Tics with their names, and without.
constexpr std::string_view times_named =
    "('10 ns' 10, '100 ns' 100, '1 µs' 1e3, '10 µs' 1e4, '100 µs' 1e5, '1 ms' 1e6)";
constexpr std::string_view times_bare = "('' 10, '' 100, '' 1e3, '' 1e4, '' 1e5, '' 1e6)";
constexpr std::string_view errors_named =
    "('10^{-16}' 1e-16, '10^{-12}' 1e-12, '10^{-8}' 1e-8, '10^{-4}' 1e-4, '1' 1)";
constexpr std::string_view errors_bare = "('' 1e-16, '' 1e-12, '' 1e-8, '' 1e-4, '' 1)";

std::string margins(const Frame& f, int height)
{
    return fmt::format("    set lmargin at screen {:.4f}; set rmargin at screen {:.4f}\n"
                       "    set tmargin at screen {:.4f}; set bmargin at screen {:.4f}\n"
                       "    set xrange [{:g}:{:g}]; set yrange [{:.3g}:{:.3g}]\n",
                       f.left / page_width, f.right / page_width, 1 - f.top / height, 1 - f.bottom / height,
                       least_error, most_error, f.least, f.most);
}

/// The headline, what stands beside marks, and the names of all solvers that the page shows, in rows of so
/// many.
std::string heading(const ErrorPoints& points, std::string_view headline, const Page& page, int per_row)
{
    const ErrorPoint& one = points.front();
    std::string text = fmt::format(
        "    set label 90 '{}' at screen 0.5, {:.4f} center font large\n"
        "    set label 91 'beside a rival’s mark, of {} hits and {} misses: M hits missed, F false "
        "hits, L hits said too late' at screen 0.5, {:.4f} center font middle_size\n",
        headline, 1 - 34.0 / page.height, one.hits, one.queries - one.hits, 1 - 78.0 / page.height);
    int place = 0;
    for (const Look& look : looks) {
        const auto shown = [&](const ErrorPoint& p) { return p.who == look.who; };
        if (std::none_of(points.begin(), points.end(), shown)) continue;
        const double x = 70 + (page_width - 80) / per_row * (place % per_row);
        const double y = 118 + 36.0 * (place / per_row);
        text +=
            fmt::format("    set label {} '{}' at screen {:.4f}, {:.4f} left point pointtype {} linecolor "
                        "rgb '{}' pointsize {} offset 1.2, 0 font middle_size\n",
                        100 + place, look.legend, x / page_width, 1 - y / page.height, look.mark, look.colour,
                        1.3 * page.mark);
        ++place;
    }
    return text;
}

std::string script(std::string_view stem, const std::string& blocks, const Sheet& sheet,
                   const std::string& drawing)
{
    return fmt::format("# Draws time per query over error of t: gnuplot {}.gp\n", stem) + blocks +
           in_both_formats(stem, sheet, drawing);
}

} // namespace

std::string error_page(const ErrorPoints& points, std::string_view stem, std::string_view headline)
{
    constexpr std::size_t columns = 4;
    constexpr double top = 200;
    constexpr double row_height = 300;
    const std::vector<ErrorPoints> questions = by_question(points);
    const std::size_t rows = (questions.size() + columns - 1) / columns;
    const int height = static_cast<int>(top + row_height * static_cast<double>(rows)) + 80;
    const Page page{height, 1.3, 6.9, 13};
    const Range range = times(points);
    std::string blocks;
    std::string drawing = "    set multiplot\n" + std::string(axes) + heading(points, headline, page, 4);
    drawing +=
        fmt::format("    set label 92 'error of t in steps, median over the hits seen: left is more exact, "
                    "lower is faster' at screen 0.5, {:.4f} center font middle_size\n",
                    20.0 / height);
    for (std::size_t k = 0; k < questions.size(); ++k) {
        const double x = 85 + 355.0 * static_cast<double>(k % columns);
        const double y = top + row_height * static_cast<double>(k / columns);
        const Frame frame{x, x + 338, y + 30, y + 266, range.least, range.most};
        const Panel shown = panel(questions[k], frame, page, k);
        blocks += shown.blocks;
        drawing += margins(frame, height);
        drawing += fmt::format("    set label 1 '{}' at graph 0.5, 1.07 center font middle_size noenhanced\n",
                               questions[k].front().pair);
        drawing += fmt::format("    set ytics {} font small\n    set xtics {} font small\n",
                               k % columns == 0 ? times_named : times_bare,
                               k + columns >= questions.size() ? errors_named : errors_bare);
        drawing += shown.plot + "    unset label\n";
    }
    drawing += "    unset multiplot\n";
    return script(stem, blocks, {.height = height, .svg = {15, 26, 18, 12}, .png = {12, 21, 14, 9}}, drawing);
}

std::string error_sheet(const ErrorPoints& points, std::string_view stem, std::string_view headline)
{
    const Page page{1000, 2.4, 11, 20};
    const Range range = times(points);
    const Frame frame{180, 1480, 220, 890, range.least, range.most};
    const Panel shown = panel(points, frame, page, 0);
    std::string drawing =
        std::string(axes) + heading(points, headline, page, 3) + margins(frame, page.height);
    drawing +=
        fmt::format("    set ytics {} font middle_size\n    set xtics {} font middle_size\n"
                    "    set ylabel 'time per query: lower is faster' offset 1, 0\n"
                    "    set xlabel 'error of t in steps, median over the hits seen: left is more exact'\n",
                    times_named, errors_named);
    int label = 110;
    for (const ErrorPoint& p : points)
        if (p.is_brink() && (p.setting == "1e-03" || p.setting == "1e-14"))
            drawing += fmt::format(
                "    set label {} '10^{{-{}}}' at {:.3e}, {:.2f} center offset 0, -1 textcolor rgb "
                "'{}' font middle_size\n",
                label++, std::stoi(p.setting.substr(3)), std::max(p.p50, least_error), p.ns, looks[0].colour);
    drawing += shown.plot + "    unset label\n";
    return script(stem, shown.blocks, {.height = 1000, .svg = {22, 32, 22, 18}, .png = {17, 25, 17, 14}},
                  drawing);
}

} // namespace brink::bench
