// SPDX-License-Identifier: BSD-3-Clause
#include "accuracy.h"
#include "ingredients.h"
#include "pair_bench.h"
#include "pair_sample.h"
#include "pairs.h"
#include "replay.h"
#include "rubble.h"
#include "scene_bench.h"
#include "stability.h"
#include "tunnelling.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>

namespace {

using namespace brink::bench;

constexpr int bad_input = 2;

struct Arguments {
    std::string out = "out";
    TunnellingOptions tunnelling;
    CLI::App* tunnelling_part = nullptr;
    CLI::App* pairs_part = nullptr;
    AccuracyOptions accuracy;
    CLI::App* accuracy_part = nullptr;
    StabilityOptions stability;
    CLI::App* stability_part = nullptr;
    IngredientOptions ingredients;
    CLI::App* ingredients_part = nullptr;
    SceneBenchOptions scene;
    RubbleOptions rubble;
    CLI::App* record_part = nullptr;
    ReplayOptions replay{recorded_workload()};
    CLI::App* replay_part = nullptr;
    bool quick = false; // a scene to 1e5 bodies
    CLI::App* scene_part = nullptr;
    std::vector<std::string> pairs{"all"};
    bool rows = false; // only print this build's rows
};

std::vector<std::string> or_all(std::vector<std::string> names)
{
    names.emplace_back("all");
    return names;
}

void describe_stability(CLI::App& part, StabilityOptions& options)
{
    part.add_option("--cases", options.cases,
                    "of each pair and class; 0: 20,000 of two spheres, 2,000 of the others")
        ->capture_default_str();
    part.add_option("--pairs", options.pairs, "which, separated by commas")
        ->delimiter(',')
        ->check(CLI::IsMember(or_all(stability_pairs())))
        ->capture_default_str();
    part.add_option("--classes", options.classes, "of difficulty: which, separated by commas")
        ->delimiter(',')
        ->check(CLI::IsMember(or_all(stability_classes())))
        ->capture_default_str();
    part.add_option("--seed", options.seed, "of the random cases")->capture_default_str();
    part.add_option("--first", options.first, "index of the first case: to go on where another run ended")
        ->capture_default_str();
    part.add_option("--threads", options.threads, "workers, each with an FCL process of its own; 0: all")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
}

void describe_accuracy(CLI::App& part, AccuracyOptions& options)
{
    part.add_option("--queries", options.queries, "of each pair, half of them hits")
        ->check(CLI::Range(100, 100'000))
        ->capture_default_str();
    part.add_option("--pairs", options.pairs, "which, separated by commas")
        ->delimiter(',')
        ->check(CLI::IsMember(or_all(accuracy_pairs())))
        ->capture_default_str();
}

void describe_scene(CLI::App& part, SceneBenchOptions& options)
{
    part.add_option("--n", options.n, "bodies, separated by commas")
        ->delimiter(',')
        ->check(CLI::Range(100, 10'000'000))
        ->capture_default_str();
    part.add_option("--scenes", options.scenes, "which, separated by commas")
        ->delimiter(',')
        ->check(CLI::IsMember(or_all(bench_scenes())))
        ->capture_default_str();
    part.add_option("--orders", options.orders, "in which the bodies are stored")
        ->delimiter(',')
        ->check(CLI::IsMember({"random", "spatial"}))
        ->capture_default_str();
    part.add_option("--threads", options.threads, "of brink, separated by commas; 1 is always measured")
        ->delimiter(',')
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    part.add_option("--steps", options.steps, "that medians are of; three of what takes long")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    part.add_option("--layers", options.layers_n,
                    "bodies of the scenes whose layers are switched off; 0: none")
        ->check(CLI::Range(0, 100'000))
        ->capture_default_str();
}

void describe(CLI::App& app, Arguments& arguments)
{
    app.require_subcommand(0, 1); // none is told in our own words
    arguments.tunnelling_part = app.add_subcommand(
        "tunnelling", "bodies through thin walls: discrete checks, FCL and brink; which are lost");
    arguments.pairs_part = app.add_subcommand(
        "pairs", "ns per query of pairs that move straight and pairs that turn, FCL beside it");
    arguments.accuracy_part = app.add_subcommand(
        "accuracy", "run time against error of t where both bodies turn, at tolerances 1e-3 to 1e-12; FCL "
                    "beside it");
    describe_accuracy(*arguments.accuracy_part, arguments.accuracy);
    arguments.stability_part = app.add_subcommand(
        "stability", "accuracy of t and wrong decisions where it is hard, against 200 digits; "
                     "textbook formulas and FCL beside it");
    describe_stability(*arguments.stability_part, arguments.stability);
    arguments.ingredients_part = app.add_subcommand(
        "ingredients", "distance evaluations per hit as the ingredients of the certificate are added");
    arguments.ingredients_part
        ->add_option("--queries", arguments.ingredients.queries, "of each pair, half of them hits")
        ->check(CLI::Range(100, 100'000))
        ->capture_default_str();
    arguments.scene_part = app.add_subcommand(
        "scene", "ms per step of whole scenes of moving bodies; FCL's and Bullet's broad phases beside it");
    describe_scene(*arguments.scene_part, arguments.scene);
    arguments.scene_part->add_flag("--quick", arguments.quick, "none of more than 100,000 bodies");
    arguments.record_part = app.add_subcommand(
        "record", "queries of a rubble pile hit by fast projectiles, simulated by Bullet: rubble.txt");
    arguments.record_part->add_option("--seed", arguments.rubble.seed, "of stones and shots")
        ->capture_default_str();
    arguments.replay_part =
        app.add_subcommand("replay", "time per query and wrong answers on recorded queries; FCL beside it");
    arguments.replay_part->add_option("--file", arguments.replay.file, "queries as text")
        ->capture_default_str();
    for (CLI::App* part :
         {arguments.tunnelling_part, arguments.pairs_part, arguments.accuracy_part, arguments.stability_part,
          arguments.ingredients_part, arguments.scene_part, arguments.record_part, arguments.replay_part})
        part->add_option("--out", arguments.out, "folder for CSVs and pictures")->capture_default_str();
    arguments.tunnelling_part
        ->add_option("--crossings", arguments.tunnelling.crossings,
                     "true crossings in each scene, over all speeds")
        ->check(CLI::Range(17, 10'000'000))
        ->capture_default_str();
    arguments.tunnelling_part->add_option("--seed", arguments.tunnelling.seed, "of the random crossings")
        ->capture_default_str();
    arguments.pairs_part->add_option("--pairs", arguments.pairs, "which, separated by commas")
        ->delimiter(',')
        ->check(CLI::IsMember(or_all(pair_names())))
        ->capture_default_str();
    arguments.pairs_part->add_flag(
        "--rows", arguments.rows,
        "only print this build's rows, as CSV on stdout (how brink-bench asks brink-bench-v3)");
}

/// What is wrong, and what would be right.
int explain(const CLI::App& app, std::string_view wrong)
{
    fmt::print(stderr, "brink-bench: {}\n\n", wrong);
    fmt::print(stderr, "{}", app.help("", CLI::AppFormatMode::All));
    return bad_input;
}

SceneBenchOptions scene_options(const Arguments& arguments)
{
    SceneBenchOptions options = arguments.scene;
    if (arguments.quick) std::erase_if(options.n, [](std::size_t n) { return n > 100'000; });
    if (options.n.empty()) throw std::invalid_argument("--quick leaves nothing of --n");
    return options;
}

int run(const Arguments& arguments, const std::filesystem::path& program)
{
    const auto all = std::find(arguments.pairs.begin(), arguments.pairs.end(), "all");
    const std::vector<std::string> names = all == arguments.pairs.end() ? arguments.pairs : pair_names();
    if (arguments.rows) {
        fmt::print("{}", timings_csv(measure_pairs(Rivals::none, names)));
        return 0;
    }
    const Output output(arguments.out);
    if (arguments.tunnelling_part->parsed()) return run_tunnelling(output, arguments.tunnelling) == 0 ? 0 : 1;
    if (arguments.accuracy_part->parsed()) return run_accuracy(output, arguments.accuracy) == 0 ? 0 : 1;
    if (arguments.stability_part->parsed()) return run_stability(output, arguments.stability) == 0 ? 0 : 1;
    if (arguments.ingredients_part->parsed())
        return run_ingredients(output, arguments.ingredients) == 0 ? 0 : 1;
    if (arguments.scene_part->parsed()) return run_scenes(output, scene_options(arguments)) == 0 ? 0 : 1;
    if (arguments.replay_part->parsed()) return run_replay(output, arguments.replay) == 0 ? 0 : 1;
    if (arguments.record_part->parsed()) {
        run_record(output, arguments.rubble);
        return 0;
    }
    run_pairs(output, names, program.parent_path() / "brink-bench-v3");
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("What brink finds, and how fast, beside FCL", "brink-bench");
    Arguments arguments;
    describe(app, arguments);
    try {
        app.parse(argc, argv);
        if (app.get_subcommands().empty())
            return explain(
                app,
                "which part? tunnelling, pairs, accuracy, stability, ingredients, scene, record or replay");
        return run(arguments, std::filesystem::canonical("/proc/self/exe"));
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        return explain(app, error.what());
    } catch (const std::exception& error) {
        fmt::print(stderr, "brink-bench: {}\n", error.what());
        return bad_input;
    }
}
