// SPDX-License-Identifier: BSD-3-Clause
#include "scene_cells.h"
#include "scene_report.h"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace brink::bench {
namespace {

constexpr std::array<std::string_view, 5> everyone{"brink", "FCL", "Bullet", "FCL two trees",
                                                   "Bullet two trees"};

/// Slope of the line of least squares through log(ms) over log(n), n >= 1e4. 0 where there is none.
double growth(const SceneResults& results, const Heading& heading, std::string_view who)
{
    double count = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const SceneFigures& f : results.figures) {
        if (f.scene != heading.scene || f.order != heading.order || f.who != who) continue;
        if (f.threads != 1 || f.n < 10'000 || f.step_ms <= 0) continue;
        const double u = std::log(static_cast<double>(f.n)), v = std::log(f.step_ms);
        count += 1;
        x += u;
        y += v;
        xx += u * u;
        xy += u * v;
    }
    const double divisor = count * xx - x * x;
    return count > 1 && divisor > 0 ? (count * xy - x * y) / divisor : 0;
}

/// A whole step of a simulator.
double simulated(const SceneFigures& f) { return f.motions_ms + f.update_ms + f.impacts_ms; }

} // namespace

std::string summary_table(const SceneResults& results)
{
    std::string rows;
    for (const Heading& h : headings(results))
        for (const SceneFigures& f : results.figures) {
            if (f.who != "brink" || f.threads != 1 || Heading{f.scene, f.order} != h || f.n < 100'000)
                continue;
            rows += fmt::format("{:<10} {:<8} {:>9} | {:>8} {:>8} {:>8}", f.scene, f.order, count(f.n),
                                ms(f.motions_ms), ms(f.step_ms), ms(f.balls_ms));
            for (const std::string_view who : {"FCL", "FCL two trees", "Bullet", "Bullet two trees"}) {
                const double theirs = step_of(find(results.figures, f.scene, f.order, who, 1, f.n));
                rows += fmt::format(" | {:>8} {:>8}", ms(theirs), times(theirs, f.step_ms));
            }
            rows += "\n";
        }
    if (rows.empty()) return "";
    return fmt::format(
               "One step: the tree and all candidate pairs, one thread, ms. Rivals are given the swept "
               "boxes; brink makes them in `motions`. `balls`: the step, with fewer pairs\n{:<10} {:<8} "
               "{:>9} | "
               "{:>8} {:>8} {:>8} | {:^17} | {:^17} | {:^17} | {:^17}\n",
               "scene", "order", "bodies", "motions", "brink", "balls", "FCL", "FCL, two trees", "Bullet",
               "Bullet, two trees") +
           rows;
}

std::string growth_table(const SceneResults& results)
{
    std::string rows;
    for (const Heading& h : headings(results)) {
        if (growth(results, h, "brink") == 0) continue;
        rows += fmt::format("{:<10} {:<8}", h.scene, h.order);
        for (const std::string_view who : everyone) {
            const double slope = growth(results, h, who);
            rows += slope == 0 ? fmt::format(" {:>16}", "-") : fmt::format(" {:>16.2f}", slope);
        }
        rows += "\n";
    }
    if (rows.empty()) return "";
    std::string text = "Growth of a step with n, from 10,000 on: the exponent\n" + fmt::format("{:<19}", "");
    for (const std::string_view who : everyone)
        text += fmt::format(" {:>16}", who);
    return text + "\n" + rows;
}

std::string skipping_table(const SceneResults& results)
{
    std::string rows;
    for (const SceneFigures& f : results.figures) {
        if (f.who != "brink") continue;
        const std::string where =
            fmt::format("{:>9} bodies, {} order, threads: {}", count(f.n), f.order, f.threads);
        if (f.scene == "bullets")
            rows += fmt::format("{}: first impact of bullets {} ms, all {} ms: {}\n", where, ms(f.first_ms),
                                ms(f.impacts_ms), times(f.impacts_ms, f.first_ms));
        const SceneFigures* gas = find(results.figures, "gas", f.order, "brink", f.threads, f.n);
        if (f.scene == "asleep" && gas != nullptr)
            rows += fmt::format(
                "{}: motions, update and impacts {} ms where 99 % sleep, {} ms where none does: {}\n", where,
                ms(simulated(f)), ms(simulated(*gas)), times(simulated(*gas), simulated(f)));
    }
    return rows.empty() ? "" : "What need not be looked at\n" + rows;
}

} // namespace brink::bench
