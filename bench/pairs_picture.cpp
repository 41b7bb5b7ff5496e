// SPDX-License-Identifier: BSD-3-Clause
#include "pairs_picture.h"

#include "output.h"

#include <algorithm>
#include <fmt/format.h>

namespace brink::bench {
namespace {

constexpr Sheet sheet{.svg = {18, 25, 21, 15}, .png = {14, 19, 16, 12}};

/// The bars and everything else but the figures. Wants headline, bottom and top (ns), and $times: pair,
/// baseline, x86-64-v3, FCL, with -1 for none.
constexpr std::string_view formulas = R"GP(
array colour[3] = ['#56B4E9', '#0072B2', '#D55E00']
array who[3] = ['brink, baseline x86-64', 'brink, x86-64-v3', 'FCL conservative advancement']
tag(ns) = ns < 0 ? 'none' : ns < 1000 ? sprintf('%.0f', ns) : sprintf('%.1f µs', ns / 1000)
height(ns) = ns < 0 ? 1.01 * bottom : ns
place(i) = column(0) + 0.28 * (i - 2)
)GP";

constexpr std::string_view drawing = R"GP(
    set title headline . ' (per query; lower is better)' font large
    set logscale y
    set yrange [bottom:top]
    set ytics ('10 ns' 10, '100 ns' 100, '1 µs' 1000, '10 µs' 10000, '100 µs' 100000) nomirror
    set ylabel 'time per query (logarithmic)'
    set grid ytics linecolor '#dddddd' linewidth 1 linetype 1
    set border 3 linecolor '#555555'
    set xtics nomirror scale 0 font small
    set bmargin 5
    set xrange [-0.6:|$times| - 0.4]
    set style fill solid 1 noborder
    set boxwidth 0.26
    set key top right horizontal Left reverse samplen 2 maxrows 1
    set label 1 'none: not measured, or FCL does not answer this pair' at screen 0.985, 0.03 right font small textcolor rgb '#444444'
    plot for [i = 1:3] $times using (place(i)):(height(column(i + 1))) with boxes \
             linecolor rgb colour[i] title who[i], \
         for [i = 1:3] $times using (place(i)):(height(column(i + 1))):(tag(column(i + 1))) with labels \
             left rotate by 90 offset 0, 0.4 font small textcolor rgb '#333333' notitle, \
         $times using 0:(bottom / 10):xticlabels(1) with points notitle
)GP";

} // namespace

std::string pairs_plot(const std::vector<Timing>& timings, Turning turning, std::string_view stem)
{
    const bool still = turning == Turning::none;
    std::string text = fmt::format("# Draws ns per query: gnuplot {}.gp\n", stem);
    text += fmt::format("headline = 'Time to first contact of two shapes that {}'\n",
                        still ? "only translate" : "turn by up to 60 degrees");
    text += fmt::format("bottom = {}\ntop = {}\n$times << END\n", still ? 10 : 100, 100'000);
    int bars = 0;
    for (const PairKind& kind : pairs_turning(turning)) {
        if (find(timings, kind.name, name_of(turning), "baseline", "mixed") == nullptr) continue;
        ++bars;
        std::string label(kind.name);
        label.replace(label.find('-'), 1, "\\n");
        std::replace(label.begin(), label.end(), '_', '-');
        text += fmt::format("\"{}\"", label);
        for (const char* who : {"baseline", "x86-64-v3", "FCL"}) {
            const Timing* timing = find(timings, kind.name, name_of(turning), who, "mixed");
            text += timing != nullptr ? fmt::format(" {:.2f}", timing->ns) : " -1";
        }
        text += "\n";
    }
    if (bars == 0) return "";
    return text + "END\n" + std::string(formulas) + in_both_formats(stem, sheet, drawing);
}

} // namespace brink::bench
