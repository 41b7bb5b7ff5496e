// SPDX-License-Identifier: BSD-3-Clause
#include "machine.h"
#include "part.h"
#include "scene_report.h"
#include "scene_rivals.h"
#include "scene_run.h"
#include "scene_threads.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>

namespace brink::bench {
namespace {

struct SceneOptions {
    std::vector<std::string> scenes{"all"};
    std::vector<std::string> orders{"random", "spatial"};
    std::vector<std::size_t> n{1'000, 10'000, 100'000, 1'000'000};
    std::vector<int> threads{1, 2};
    int steps = 7;                 // that medians are of; fewer of what takes long
    std::size_t layers_n = 10'000; // bodies of the scenes whose layers are switched off; 0: none
};

std::vector<std::string> bench_scenes() { return {support::scene_names.begin(), support::scene_names.end()}; }

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

SceneResults measure(const SceneOptions& options)
{
    const std::vector<std::string> scenes = chosen(options.scenes, bench_scenes());
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

/// ms to build, to update, to find pairs and impacts of whole scenes of moving bodies, the broad phases of
/// FCL and Bullet beside it over the same swept boxes; what each layer saves.
class SceneBench final : public Part {
public:
    std::string_view name() const override { return "scene"; }
    std::string_view about() const override
    {
        return "ms per step of whole scenes of moving bodies; FCL's and Bullet's broad phases beside it";
    }
    std::string_view csv() const override { return "scenes.csv"; }
    void describe(CLI::App&) override;
    std::uint64_t run(const Output&, Effort) override;
    std::vector<Figure> figures(const Csv&) const override;
    std::vector<Picture> pictures() const override;

private:
    SceneOptions options_;
};

void SceneBench::describe(CLI::App& command)
{
    command.add_option("--n", options_.n, "bodies, separated by commas")
        ->delimiter(',')
        ->check(CLI::Range(100, 10'000'000))
        ->capture_default_str();
    add_choice(command, "--scenes", options_.scenes, bench_scenes());
    command.add_option("--orders", options_.orders, "in which the bodies are stored")
        ->delimiter(',')
        ->check(CLI::IsMember({"random", "spatial"}))
        ->capture_default_str();
    command.add_option("--threads", options_.threads, "of brink, separated by commas; 1 is always measured")
        ->delimiter(',')
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command.add_option("--steps", options_.steps, "that medians are of; three of what takes long")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command
        .add_option("--layers", options_.layers_n,
                    "bodies of the scenes whose layers are switched off; 0: none")
        ->check(CLI::Range(0, 100'000))
        ->capture_default_str();
}

/// Quick: none of more than 100,000 bodies, in spatial order, which is best for the rivals.
SceneOptions quickened(SceneOptions options)
{
    std::erase_if(options.n, [](std::size_t n) { return n > 100'000; });
    options.orders = {"spatial"};
    options.steps = std::min(options.steps, 3);
    options.layers_n = std::min<std::size_t>(options.layers_n, 3'000);
    if (options.n.empty()) throw std::invalid_argument("--quick leaves nothing of --n");
    return options;
}

std::uint64_t SceneBench::run(const Output& output, Effort effort)
{
    const SceneResults results = measure(effort == Effort::quick ? quickened(options_) : options_);
    fmt::print("{}\n", what_is_measured(results.bandwidth));
    for (const std::string& table :
         {scene_tables(results), summary_table(results), thread_table(results), growth_table(results),
          skipping_table(results), layer_table(results), ledger_tables(results)})
        if (!table.empty()) fmt::print("{}\n", table);
    output.write(csv(), scenes_csv(results));
    if (!results.layers.empty()) output.write("scene_layers.csv", layers_csv(results));
    fmt::print("CSV: {}\n{}\n", output.path_of(csv()), output.draw("scenes", scenes_plot(results)));
    if (results.wrong > 0)
        fmt::print("WRONG: a rival's pairs were not brink's {} times, see stderr\n", results.wrong);
    return static_cast<std::uint64_t>(results.wrong);
}

/// A step: the tree and all pairs, of a body.
std::vector<Figure> SceneBench::figures(const Csv& csv) const
{
    std::vector<Figure> figures;
    for (std::size_t i = 0; i < csv.rows(); ++i) {
        const std::string threads = csv.text(i, "threads");
        figures.push_back({.question = fmt::format("{}, {} bodies in {} order", csv.text(i, "scene"),
                                                   thousands(csv.count(i, "bodies")), csv.text(i, "order")),
                           .who = csv.text(i, "who") + (threads == "1" ? "" : ", " + threads + " threads"),
                           .time = csv.number(i, "step_ms") * 1e6 / csv.number(i, "bodies")});
    }
    return figures;
}

std::vector<Picture> SceneBench::pictures() const
{
    return {{"scenes", "A step of a whole scene over its number of bodies: brink's lines lie lowest and are "
                       "no steeper than the memory's."}};
}

} // namespace

std::unique_ptr<Part> scene_part() { return std::make_unique<SceneBench>(); }

} // namespace brink::bench
