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

/// "0" only where there is none: a share that would round to it is shown as less than the last digit.
std::string share(int part, int whole)
{
    if (part == 0) return "0";
    if (percent(part, whole) < 0.005) return "<0.01";
    return fmt::format("{:.{}f}", percent(part, whole), percent(part, whole) < 10 ? 2 : 1);
}

std::string span(const Interval& i) { return fmt::format("{:.3f}-{:.3f}", i.low, i.high); }

void add_scene(fmt::memory_buffer& text, const std::vector<Row>& rows, const Scene& scene)
{
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "\n{}: {} true crossings; speed in units of {}\n", scene.title,
                   thousands(total(rows, scene, methods.back()).crossings), scene.thickness);
    fmt::format_to(out, "  {:<29} {:>36}   {:>8}  {:>13}  {:>8}  {:>10}  {:>9}\n", "",
                   "missed, % of true crossings, at speed", "missed,", "95 % interval", "late,", "late by up",
                   "ns per");
    fmt::format_to(out, "  {:<29}  {:>6} {:>6} {:>6} {:>6} {:>6}   {:>8}  {:>13}  {:>8}  {:>10}  {:>9}\n",
                   "method", "0.1", "1", "10", "100", "1000", "% of all", "% of all", "% of all", "to, steps",
                   "step");
    for (const Method& method : methods) {
        fmt::format_to(out, "  {:<29} ", method.title);
        for (const Row& row : rows) {
            if (row.scene != &scene || row.method != &method) continue;
            const auto is_speed = [&](double decade) { return std::abs(row.speed / decade - 1) < 1e-9; };
            if (std::any_of(decades.begin(), decades.end(), is_speed))
                fmt::format_to(out, " {:>6}", share(row.tally.missed, row.tally.crossings));
        }
        const Tally all = total(rows, scene, method);
        fmt::format_to(out, "   {:>8}  {:>13}  {:>8}  {:>10.1e}  {:>9.0f}\n",
                       share(all.missed, all.crossings), span(confidence(all.missed, all.crossings)),
                       share(all.late, all.crossings), all.latest, all.ns);
    }
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

double percent(int part, int whole) { return 100.0 * part / whole; }

Interval confidence(int part, int whole)
{
    constexpr double z = 1.959963984540054; // of the normal distribution, 2.5 % beyond it
    const double n = whole;
    const double middle = part + 0.5 * z * z;
    const double half = z * std::sqrt(part * (n - part) / n + 0.25 * z * z);
    return {std::max(0.0, 100 * (middle - half) / (n + z * z)), 100 * (middle + half) / (n + z * z)};
}

std::string tunnelling_csv(const std::vector<Row>& rows)
{
    std::string text = "scene,method,speed_over_thickness,crossings,missed,missed_percent,missed_low_percent,"
                       "missed_high_percent,late,latest_steps,earliest_steps,"
                       "ns_per_query\n";
    for (const Row& row : rows) {
        const Tally& tally = row.tally;
        const Interval likely = confidence(tally.missed, tally.crossings);
        text += fmt::format("{},{},{:.4g},{},{},{:.4g},{:.4g},{:.4g},{},{:.3g},{:.3g},{:.1f}\n",
                            row.scene->name, row.method->name, row.speed, tally.crossings, tally.missed,
                            percent(tally.missed, tally.crossings), likely.low, likely.high, tally.late,
                            tally.latest, tally.earliest, tally.ns);
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

} // namespace brink::bench
