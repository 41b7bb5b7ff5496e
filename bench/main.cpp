// SPDX-License-Identifier: BSD-3-Clause
#include "pair_bench.h"
#include "pair_sample.h"
#include "pairs.h"
#include "tunnelling.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>

namespace {

using namespace brink::bench;

constexpr int bad_input = 2;

struct Arguments {
    std::string out = "out";
    TunnellingOptions tunnelling;
    CLI::App* tunnelling_part = nullptr;
    CLI::App* pairs_part = nullptr;
    std::vector<std::string> pairs{"all"};
    bool rows = false; // only print this build's rows
};

void describe(CLI::App& app, Arguments& arguments)
{
    app.require_subcommand(0, 1); // none is told in our own words
    arguments.tunnelling_part = app.add_subcommand(
        "tunnelling", "bodies through thin walls: discrete checks, FCL and brink; which are lost");
    arguments.pairs_part =
        app.add_subcommand("pairs", "ns per query of every closed-form pair, FCL beside it");
    for (CLI::App* part : {arguments.tunnelling_part, arguments.pairs_part})
        part->add_option("--out", arguments.out, "folder for CSVs and pictures")->capture_default_str();
    arguments.tunnelling_part
        ->add_option("--crossings", arguments.tunnelling.crossings,
                     "true crossings in each scene, over all speeds")
        ->check(CLI::Range(17, 10'000'000))
        ->capture_default_str();
    arguments.tunnelling_part->add_option("--seed", arguments.tunnelling.seed, "of the random crossings")
        ->capture_default_str();
    std::vector<std::string> names = pair_names();
    names.emplace_back("all");
    arguments.pairs_part->add_option("--pairs", arguments.pairs, "which, separated by commas")
        ->delimiter(',')
        ->check(CLI::IsMember(names))
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
        if (app.get_subcommands().empty()) return explain(app, "which part? tunnelling or pairs");
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
