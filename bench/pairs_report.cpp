// SPDX-License-Identifier: BSD-3-Clause
#include "pairs_report.h"

#include "pair_sample.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

namespace brink::bench {
namespace {

std::optional<double> find(const std::vector<Timing>& timings, std::string_view pair, std::string_view who,
                           std::string_view what)
{
    const auto found = std::find_if(timings.begin(), timings.end(), [&](const Timing& t) {
        return t.pair == pair && t.who == who && t.what == what;
    });
    if (found == timings.end()) return std::nullopt;
    return found->ns;
}

auto first_of(const std::vector<Timing>& timings, std::string_view what)
{
    return std::find_if(timings.begin(), timings.end(), [&](const Timing& t) { return t.what == what; });
}

std::string cell(std::optional<double> ns)
{
    return ns ? fmt::format("{:.{}f}", *ns, *ns < 100 ? 1 : 0) : "-";
}

std::string ratio(std::optional<double> theirs, std::optional<double> ours)
{
    return theirs && ours ? fmt::format("{:.0f} x", *theirs / *ours) : "-";
}

double worst_deviation(const std::vector<Timing>& timings)
{
    double worst = 0;
    for (const Timing& t : timings)
        worst = std::max(worst, 100 * t.deviation / t.ns);
    return worst;
}

/// The bars and everything else but the figures. Wants $times: pair, baseline, x86-64-v3, FCL, with -1 for
/// none.
constexpr std::string_view script = R"GP(
array colour[3] = ['#56B4E9', '#0072B2', '#D55E00']
array who[3] = ['brink, baseline x86-64', 'brink, x86-64-v3', 'FCL conservative advancement']
bottom = 10
tag(ns) = ns < 0 ? '–' : ns < 1000 ? sprintf('%.0f', ns) : sprintf('%.1f µs', ns / 1000)
height(ns) = ns < 0 ? 1.01 * bottom : ns
place(i) = column(0) + 0.28 * (i - 2)

do for [format in 'svg png'] {
    if (format eq 'svg') {
        set terminal svg size 1500,760 dynamic enhanced font 'DejaVu Sans,18' background '#ffffff'
        large = ',25'; small = ',15'
    } else {
        set terminal pngcairo size 1500,760 enhanced font 'DejaVu Sans,14' background '#ffffff'
        large = ',19'; small = ',12'
    }
    set output 'pairs.' . format
    set title "Time to find when two moving shapes first touch (ns per query, half of them hits; lower is better)" font large
    set logscale y
    set yrange [bottom:10000]
    set ytics ('10 ns' 10, '100 ns' 100, '1 µs' 1000, '10 µs' 10000) nomirror
    set ylabel 'time per query (logarithmic)'
    set grid ytics linecolor '#dddddd' linewidth 1 linetype 1
    set border 3 linecolor '#555555'
    set xtics nomirror scale 0
    set bmargin 5
    set xrange [-0.6:|$times| - 0.4]
    set style fill solid 1 noborder
    set boxwidth 0.26
    set key top right horizontal Left reverse samplen 2 maxrows 1
    set label 1 '–  FCL has none for this pair' at graph 0.985, 0.90 right font small textcolor rgb '#444444'
    plot for [i = 1:3] $times using (place(i)):(height(column(i + 1))) with boxes \
             linecolor rgb colour[i] title who[i], \
         for [i = 1:3] $times using (place(i)):(height(column(i + 1))):(tag(column(i + 1))) with labels \
             offset 0, 0.6 font small textcolor rgb '#333333' notitle, \
         $times using 0:(bottom / 10):xticlabels(1) with points notitle
    unset output
}
)GP";

} // namespace

std::string pairs_table(const std::vector<Timing>& timings)
{
    const auto first = first_of(timings, "mixed");
    if (first == timings.end()) return "";
    std::string text =
        "One query through time_of_impact, ns: mean processor time, contact detail unless time_only.\n";
    text += fmt::format("{:<19} | {:^31} | {:^31} | {:^25}\n", "closed forms,", "brink, baseline x86-64",
                        "brink, x86-64-v3", "FCL advancement");
    text += fmt::format("{:<19} |", "nothing rotates");
    for (int build = 0; build < 2; ++build)
        text += fmt::format(" {:>6} {:>6} {:>6} {:>10} |", "mixed", "hits", "misses", "time_only");
    text += fmt::format(" {:>6} {:>9} {:>8}\n", "mixed", "/baseline", "/v3");
    for (const PairKind& kind : closed_pairs()) {
        const auto get = [&](std::string_view who, std::string_view what) {
            return find(timings, kind.name, who, what);
        };
        if (!get("baseline", "mixed")) continue;
        text += fmt::format("{:<19} |", kind.name);
        for (const char* build : {"baseline", "x86-64-v3"})
            text += fmt::format(" {:>6} {:>6} {:>6} {:>10} |", cell(get(build, "mixed")),
                                cell(get(build, "hits")), cell(get(build, "misses")),
                                cell(get(build, "mixed time_only")));
        const auto fcl = get("FCL", "mixed");
        text += fmt::format(" {:>6} {:>9} {:>8}\n", cell(fcl), ratio(fcl, get("baseline", "mixed")),
                            ratio(fcl, get("x86-64-v3", "mixed")));
    }
    return text +
           fmt::format(
               "{} distinct pairs of 2,048 bodies, {} repetitions (FCL: 4,096 pairs); mixed: half hit. "
               "Largest deviation between repetitions {:.0f} %.\n"
               "-: FCL has no conservative advancement for this pair.\n",
               first->queries, first->repetitions, worst_deviation(timings));
}

std::string rotating_table(const std::vector<Timing>& timings)
{
    if (first_of(timings, "rotating") == timings.end()) return "";
    std::string text = "Certified advancement, rotation up to 60 degrees, ns, half hit\n";
    text += fmt::format("{:<19} | {:>9} | {:>9} | {:>9}\n", "", "baseline", "v3", "FCL");
    for (const PairKind& kind : rotating_pairs()) {
        if (!find(timings, kind.name, "baseline", "rotating")) continue;
        text += fmt::format("{:<19} | {:>9} | {:>9} | {:>9}\n", kind.name,
                            cell(find(timings, kind.name, "baseline", "rotating")),
                            cell(find(timings, kind.name, "x86-64-v3", "rotating")),
                            cell(find(timings, kind.name, "FCL", "rotating")));
    }
    return text;
}

std::string pairs_plot(const std::vector<Timing>& timings)
{
    if (first_of(timings, "mixed") == timings.end()) return "";
    std::string text = "# Draws ns per query: gnuplot pairs.gp\n$times << END\n";
    for (const PairKind& kind : closed_pairs()) {
        if (!find(timings, kind.name, "baseline", "mixed")) continue;
        std::string label(kind.name);
        label.replace(label.find('-'), 1, "\\n");
        std::replace(label.begin(), label.end(), '_', '-');
        text += fmt::format("\"{}\"", label);
        for (const char* who : {"baseline", "x86-64-v3", "FCL"}) {
            const auto ns = find(timings, kind.name, who, "mixed");
            text += ns ? fmt::format(" {:.2f}", *ns) : " -1";
        }
        text += "\n";
    }
    return text + "END\n" + std::string(script);
}

} // namespace brink::bench
