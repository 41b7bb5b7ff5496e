// SPDX-License-Identifier: BSD-3-Clause
#include "scene_report.h"

#include "scene_cells.h"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

namespace brink::bench {
namespace {

std::string rival_cells(const SceneFigures* f, double ours)
{
    if (f == nullptr) return fmt::format(" | {:>7} {:>7} {:>7} {:>4} {:>7}", "-", "-", "-", "-", "-");
    return fmt::format(" | {:>7} {:>7} {:>7} {:>4.0f} {:>7}", ms(f->build_ms), ms(f->update_ms),
                       ms(f->pairs_ms), f->bytes, times(f->step_ms, ours));
}

std::string scene_row(const SceneResults& results, const SceneFigures& f)
{
    const auto other = [&](std::string_view who) {
        return find(results.figures, f.scene, f.order, who, 1, f.n);
    };
    std::string row =
        fmt::format("{:>9} {:>6.2f} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>4.0f} {:>7}",
                    count(f.n), static_cast<double>(f.pairs) / static_cast<double>(f.n), ms(f.build_ms),
                    ms(f.motions_ms), ms(f.update_ms), ms(f.pairs_ms), ms(f.step_ms), ms(f.balls_ms),
                    ms(f.impacts_ms), ms(f.first_ms), f.bytes, times(f.step_ms, f.floor_ms));
    row += rival_cells(other("FCL"), f.step_ms) + rival_cells(other("Bullet"), f.step_ms);
    const SceneFigures* fcl = other("FCL two trees");
    const SceneFigures* bullet = other("Bullet two trees");
    if (fcl != nullptr || bullet != nullptr)
        row += fmt::format(" | {:>7} {:>7} {:>7} {:>7}", ms(step_of(fcl)), times(step_of(fcl), f.step_ms),
                           ms(step_of(bullet)), times(step_of(bullet), f.step_ms));
    return row + "\n";
}

enum class Columns : unsigned char { one_tree, two_trees };

std::string heading_of(Columns columns)
{
    const bool two = columns == Columns::two_trees;
    std::string text = fmt::format("{:>9} {:>6} {:^79} | {:^36} | {:^36}{}\n", "", "pairs/", "brink", "FCL",
                                   "Bullet", two ? " | two trees" : "");
    text += fmt::format("{:>9} {:>6} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>4} {:>7}", "bodies",
                        "body", "build", "motions", "update", "pairs", "step", "balls", "impacts", "first",
                        "B", "/floor");
    for (int rival = 0; rival < 2; ++rival)
        text += fmt::format(" | {:>7} {:>7} {:>7} {:>4} {:>7}", "build", "update", "pairs", "B", "/brink");
    if (two) text += fmt::format(" | {:>7} {:>7} {:>7} {:>7}", "FCL", "/brink", "Bullet", "/brink");
    return text + "\n";
}

bool has_two_trees(const SceneResults& results, const Heading& h)
{
    return std::any_of(results.figures.begin(), results.figures.end(), [&](const SceneFigures& f) {
        return Heading{f.scene, f.order} == h && f.who == "FCL two trees";
    });
}

} // namespace

std::string scene_tables(const SceneResults& results)
{
    std::string text;
    for (const Heading& h : headings(results)) {
        text += fmt::format("{}, bodies in {} order, one thread\n", h.scene, h.order) +
                heading_of(has_two_trees(results, h) ? Columns::two_trees : Columns::one_tree);
        for (const SceneFigures& f : results.figures)
            if (f.who == "brink" && f.threads == 1 && Heading{f.scene, f.order} == h)
                text += scene_row(results, f);
        text += "\n";
    }
    return text;
}

std::string thread_table(const SceneResults& results)
{
    std::string rows;
    for (const SceneFigures& f : results.figures) {
        const SceneFigures* one = find(results.figures, f.scene, f.order, "brink", 1, f.n);
        if (f.who != "brink" || f.threads == 1 || one == nullptr) continue;
        rows += fmt::format("{:<10} {:<8} {:>9} {:>7} | {:>7} {:>6} | {:>7} {:>6} | {:>7} {:>6} | {:>7} "
                            "{:>6} | {:>7} {:>6}\n",
                            f.scene, f.order, count(f.n), f.threads, ms(f.update_ms),
                            times(one->update_ms, f.update_ms), ms(f.pairs_ms),
                            times(one->pairs_ms, f.pairs_ms), ms(f.step_ms), times(one->step_ms, f.step_ms),
                            ms(f.impacts_ms), times(one->impacts_ms, f.impacts_ms), ms(f.first_ms),
                            times(one->first_ms, f.first_ms));
    }
    if (rows.empty()) return "";
    return fmt::format("More threads: brink, ms, and how many times faster than with one\n{:<10} {:<8} {:>9} "
                       "{:>7} | {:>14} | {:>14} | {:>14} | {:>14} | {:>14}\n",
                       "scene", "order", "bodies", "threads", "update", "pairs", "step", "impacts", "first") +
           rows;
}

std::string layer_table(const SceneResults& results)
{
    if (results.layers.empty()) return "";
    std::string text = fmt::format(
        "What each layer saves: {} bodies in spatial order, one thread, with that layer switched off\n"
        "{:<10} {:<10} | {:>11} {:>14} | {:>11} {:>14}\n",
        count(results.layers.front().n), "scene", "without", "impacts, ms", "asked exactly", "first, ms",
        "asked exactly");
    for (const LayerFigures& f : results.layers) {
        if (f.skipped) {
            text +=
                fmt::format("{:<10} {:<10} | left out: more than half a minute, by a tenth of the bodies\n",
                            f.scene, f.without);
            continue;
        }
        text += fmt::format("{:<10} {:<10} | {:>11} {:>14} | {:>11} {:>14}\n", f.scene, f.without,
                            ms(f.impacts_ms), count(f.impacts_exact), ms(f.first_ms), count(f.first_exact));
    }
    return text +
           "simd: one body at a time in place of sixteen; it removes no pair. mask, filter: what they save "
           "is what a user's\nown exclude, and no scene here excludes any.\n";
}

std::string ledger_tables(const SceneResults& results)
{
    std::ostringstream text;
    for (const SceneLedgers& l : results.ledgers) {
        const bool last = std::none_of(&l + 1, results.ledgers.data() + results.ledgers.size(),
                                       [&](const SceneLedgers& other) { return other.scene == l.scene; });
        if (!last) continue;
        text << fmt::format("Ledger: all impacts of {}, {} bodies, one thread\n", l.scene, count(l.n))
             << l.impacts
             << fmt::format("Ledger: the first impact of {}, {} bodies, one thread\n", l.scene, count(l.n))
             << l.first << '\n';
    }
    return text.str();
}

std::string scenes_csv(const SceneResults& results)
{
    std::string text =
        "scene,order,who,threads,bodies,movers,pairs,impacts,steps,build_ms,motions_ms,update_ms,"
        "pairs_ms,step_ms,balls_ms,ball_pairs,impacts_ms,first_ms,bytes_per_body,heap_per_body,floor_ms\n";
    for (const SceneFigures& f : results.figures)
        text += fmt::format(
            "{},{},{},{},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{},{:.6g},{:.6g},{:."
            "4g},{:.4g},{:.4g}\n",
            f.scene, f.order, f.who, f.threads, f.n, f.movers, f.pairs, f.impacts, f.steps, f.build_ms,
            f.motions_ms, f.update_ms, f.pairs_ms, f.step_ms, f.balls_ms, f.ball_pairs, f.impacts_ms,
            f.first_ms, f.bytes, f.heap, f.floor_ms);
    return text;
}

std::string layers_csv(const SceneResults& results)
{
    std::string text = "scene,bodies,without,impacts_ms,impacts_exact,first_ms,first_exact\n";
    for (const LayerFigures& f : results.layers)
        if (!f.skipped)
            text += fmt::format("{},{},{},{:.6g},{},{:.6g},{}\n", f.scene, f.n, f.without, f.impacts_ms,
                                f.impacts_exact, f.first_ms, f.first_exact);
    return text;
}

} // namespace brink::bench
