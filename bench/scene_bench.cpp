// SPDX-License-Identifier: BSD-3-Clause
#include "scene_bench.h"

#include "machine.h"
#include "scene_report.h"
#include "scene_rivals.h"
#include "scene_run.h"
#include "scene_threads.h"

#include <algorithm>
#include <fmt/format.h>

namespace brink::bench {
namespace {

std::vector<std::string> chosen(const std::vector<std::string>& names)
{
    return std::find(names.begin(), names.end(), "all") == names.end() ? names : bench_scenes();
}

/// One thread first: the rivals run beside it.
std::vector<int> thread_counts(std::vector<int> wanted)
{
    wanted.push_back(1);
    std::sort(wanted.begin(), wanted.end());
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    if (!have_threads()) wanted = {1};
    return wanted;
}

std::string what_is_measured(double bandwidth)
{
    const std::string bullet =
        bullet_version().empty()
            ? "Bullet was not found when this was built: its columns are empty.\n"
            : fmt::format("Bullet {}: btDbvt, the boxes as they are, without the margin that its own broad "
                          "phase adds.\n",
                          bullet_version());
    return fmt::format(
        "{}\nMemory hands {:.1f} GB a second to one thread.{}\n\n"
        "Every mover moves in every step, ms, medians. build: n bodies added and made ready (rivals: n "
        "boxes). motions: set_motions,\nwhich checks them and makes the swept boxes (rivals are given them). "
        "update: the tree. pairs: all pairs whose boxes overlap.\nstep: update and pairs. balls: the same "
        "with only "
        "the pairs whose swept balls meet too. impacts, first: Scene::impacts and\nfirst_impact. B: bytes a "
        "body of "
        "the broad phase; rivals: on the heap, without the objects that the tree refers to. /brink: "
        "their\nstep "
        "over brink's.\n"
        "FCL: DynamicAABBTreeCollisionManager<double> over the same boxes; all in one tree, of pairs that do "
        "not move none kept. Where fewer\nthan one in ten moves, each mover is updated and asked by itself, "
        "which is the faster way; and beside it with two trees, one of\nthem for what does not move. {}",
        machine(), bandwidth / 1e9, have_threads() ? "" : " No oneTBB when this was built: one thread only.",
        bullet);
}

SceneResults measure(const SceneBenchOptions& options)
{
    const std::vector<std::string> scenes = chosen(options.scenes);
    std::vector<std::size_t> sizes = options.n;
    std::sort(sizes.begin(), sizes.end());
    const std::size_t tasks = scenes.size() * options.orders.size() * sizes.size();
    const std::size_t layered = options.layers_n > 0 ? scenes.size() : 0;
    Progress progress("scenes", static_cast<int>(tasks + layered));
    SceneResults results;
    results.bandwidth = read_bandwidth();
    for (const std::size_t n : sizes)
        for (const std::string& scene : scenes)
            for (const std::string& order : options.orders) {
                results = measure_scene({scene, order, n, thread_counts(options.threads), options.steps},
                                        std::move(results));
                progress.step();
            }
    for (std::size_t i = 0; i < layered; ++i) {
        const std::vector<LayerFigures> layers = measure_layers(scenes[i], options.layers_n);
        results.layers.insert(results.layers.end(), layers.begin(), layers.end());
        progress.step();
    }
    return results;
}

} // namespace

std::vector<std::string> bench_scenes() { return {support::scene_names.begin(), support::scene_names.end()}; }

int run_scenes(const Output& output, const SceneBenchOptions& options)
{
    const SceneResults results = measure(options);
    fmt::print("{}\n", what_is_measured(results.bandwidth));
    for (const std::string& table :
         {scene_tables(results), summary_table(results), thread_table(results), growth_table(results),
          skipping_table(results), layer_table(results), ledger_tables(results)})
        if (!table.empty()) fmt::print("{}\n", table);
    output.write("scenes.csv", scenes_csv(results));
    if (!results.layers.empty()) output.write("scene_layers.csv", layers_csv(results));
    fmt::print("CSV: {}\n{}\n", output.path_of("scenes.csv"), output.draw("scenes", scenes_plot(results)));
    if (results.wrong > 0)
        fmt::print("WRONG: a rival's pairs were not brink's {} times, see stderr\n", results.wrong);
    return results.wrong;
}

} // namespace brink::bench
