// SPDX-License-Identifier: BSD-3-Clause
#include "campaign.h"
#include "keep.h"
#include "replay.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>

namespace {

using namespace brink::fuzz;
using brink::support::all_pairs;
using brink::support::KeptQuery;
using brink::support::pair_named;
using brink::support::read_queries;

constexpr int disagreed = 1;
constexpr int misused = 2;
constexpr int failed = 3; // no process, no memory

std::string known_pairs()
{
    std::string out = "all, closed (with a closed form), advancement (the others), smooth (two of cylinder, "
                      "cone, ellipsoid), solid (one or two of those or of hull)";
    for (const Pair& pair : all_pairs())
        out += ", " + pair.name();
    return out;
}

std::string unknown_pair(const std::string& name)
{
    return "no pair is called '" + name + "'. There are: " + known_pairs();
}

bool smooth(std::size_t shape) { return shape >= 6 && shape < 9; }
bool smooth(const Pair& pair) { return smooth(pair.first) && smooth(pair.second); }

/// One name of --pairs: a pair or a group of pairs.
std::vector<Pair> named(const std::string& name)
{
    std::vector<Pair> out;
    for (const Pair& pair : all_pairs()) {
        const bool in_group = name == "all" || (name == "closed" && pair.closed_form()) ||
                              (name == "advancement" && !pair.closed_form() && !pair.unbounded()) ||
                              (name == "smooth" && smooth(pair)) || (name == "solid" && pair.second >= 6);
        if (in_group || pair.name() == name) out.push_back(pair);
    }
    return out;
}

struct Arguments {
    Plan plan;
    std::vector<std::string> pairs{"all"};
    std::string pair;
    std::uint64_t index = 0;
    std::string file; // to replay
    std::string keep;
};

void add_keep(CLI::App& part, Arguments& arguments)
{
    part.add_option("--keep", arguments.keep, "file to write the disagreements to, for replay");
}

const CLI::App* add_run(CLI::App& app, Arguments& arguments)
{
    Plan& plan = arguments.plan;
    CLI::App* run = app.add_subcommand("run", "Put brink on trial over many cases");
    run->add_option("--cases", plan.cases, "cases for each pair")
        ->check(CLI::Range(std::uint64_t{1}, ~std::uint64_t{0} / 2))
        ->capture_default_str();
    run->add_option("--seed", plan.seed, "which campaign; a case is a function of seed and index")
        ->capture_default_str();
    run->add_option("--first", plan.first, "index of the first case")->capture_default_str();
    run->add_option("--pairs", arguments.pairs, known_pairs())
        ->delimiter(',')
        ->check(
            [](const std::string& name) { return named(name).empty() ? unknown_pair(name) : std::string(); });
    run->add_option("--threads", plan.threads, "workers, each with an FCL process of its own")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    run->add_option("--ask-every", plan.ask_every,
                    "every which case brink is asked in other ways: time_only, t_max, swapped, moved")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    run->add_option("--rule-every", plan.rule_every,
                    "every which case the referee judges, in 100 digits where long double proves nothing; "
                    "always those that the judge in doubles, which sees every case, does not acquit")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    run->add_option("--digits-every", plan.digits_every,
                    "every which case it finds the contact of in 100 digits, closed forms in 200 as well")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    run->add_option("--reference-every", plan.reference_every, "every which case the dense reference judges")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    run->add_option("--witness-every", plan.witness_every, "every which case FCL and libccd judge")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    add_keep(*run, arguments);
    return run;
}

const CLI::App* add_show(CLI::App& app, Arguments& arguments)
{
    CLI::App* show = app.add_subcommand("show", "Print one case as C++, with what every judge says");
    show->add_option("--pair", arguments.pair, "pair of shapes")
        ->required()
        ->check(
            [](const std::string& name) { return pair_named(name) ? std::string() : unknown_pair(name); });
    show->add_option("--seed", arguments.plan.seed, "as in run")->capture_default_str();
    show->add_option("--index", arguments.index, "which case")->required();
    return show;
}

const CLI::App* add_replay(CLI::App& app, Arguments& arguments)
{
    CLI::App* replay = app.add_subcommand("replay", "Put every query of a file before every judge");
    replay->add_option("file", arguments.file, "queries as text: kept by run, or recorded")->required();
    replay->add_option("--threads", arguments.plan.threads, "as in run")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    add_keep(*replay, arguments);
    return replay;
}

/// The end of a campaign: the tally, and what to exit with.
int conclude(Keep& keep, const std::vector<Pair>& pairs, const std::vector<Tally>& tallies,
             const std::string& stopped)
{
    fmt::print("{}", report(pairs, tallies));
    keep.write(queries_of(pairs, tallies));
    std::uint64_t findings = 0;
    for (const Tally& tally : tallies)
        findings += tally.brink_findings();
    fmt::print("{}{} disagreements that are brink's\n", stopped, findings);
    return findings > 0 ? disagreed : 0;
}

int run_replay(const Arguments& arguments, const std::vector<KeptQuery>& queries, Keep& keep)
{
    const Replayed out = replay(queries, arguments.plan.threads);
    return conclude(keep, out.pairs, out.tallies, out.stopped ? "stopped before the end\n" : "");
}

int run_campaign(Arguments& arguments, Keep& keep)
{
    for (const Pair& pair : all_pairs())
        for (const std::string& name : arguments.pairs) {
            const std::vector<Pair> group = named(name);
            const auto same = [&](const Pair& p) { return p.first == pair.first && p.second == pair.second; };
            if (std::none_of(group.begin(), group.end(), same)) continue;
            arguments.plan.pairs.push_back(pair);
            break;
        }
    const Outcome outcome = run(arguments.plan);
    const std::string stopped = outcome.stopped ? fmt::format("stopped: go on with --seed {} --first {}\n",
                                                              arguments.plan.seed, outcome.next)
                                                : "";
    return conclude(keep, arguments.plan.pairs, outcome.tallies, stopped);
}

int dispatch(int argc, char** argv)
{
    CLI::App app{"brink-fuzz: brink's time of impact against judges in doubles, long double and 100 digits, "
                 "FCL and libccd"};
    app.require_subcommand(0, 1);
    Arguments arguments;
    const CLI::App* run = add_run(app, arguments);
    const CLI::App* show_one = add_show(app, arguments);
    const CLI::App* replay_file = add_replay(app, arguments);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const bool asked_for_help = error.get_exit_code() == 0;
        if (asked_for_help) return app.exit(error);
        std::cerr << "brink-fuzz: " << error.what() << "\n\n" << app.help();
        return misused;
    }
    if (run->parsed() || replay_file->parsed()) {
        std::optional<Keep> keep;
        std::vector<KeptQuery> queries;
        try {
            if (replay_file->parsed()) queries = read_queries(std::filesystem::path(arguments.file));
            keep.emplace(arguments.keep);
        } catch (const std::runtime_error& error) {
            std::cerr << "brink-fuzz: " << error.what() << '\n';
            return misused;
        }
        return run->parsed() ? run_campaign(arguments, *keep) : run_replay(arguments, queries, *keep);
    }
    if (!show_one->parsed()) {
        std::cerr << "brink-fuzz: no command given\n\n" << app.help();
        return misused;
    }
    fmt::print("{}", show(*pair_named(arguments.pair), arguments.plan.seed, arguments.index));
    return 0;
}

} // namespace

int main(int argc, char** argv)
try {
    return dispatch(argc, argv);
} catch (const std::exception& error) {
    std::cerr << "brink-fuzz: " << error.what() << '\n';
    return failed;
}
