// SPDX-License-Identifier: BSD-3-Clause
#include "compare.h"
#include "part.h"
#include "report.h"
#include "rubble.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <exception>

namespace {

using namespace brink::bench;

constexpr int broke_a_promise = 1;
constexpr int got_worse = 1;
constexpr int bad_input = 2;

struct Command {
    std::string out = "out";
    Effort effort = Effort::usual;
    CLI::App* all = nullptr;
    bool go_on = false;
    CLI::App* record = nullptr;
    RubbleOptions rubble;
    CLI::App* compare = nullptr;
    std::string before, after;
    std::vector<CLI::App*> parts; // as all_parts()
};

void describe(CLI::App& app, Command& command, const std::vector<std::unique_ptr<Part>>& parts)
{
    app.require_subcommand(0, 1); // none is told in our own words
    const auto writes = [&command](CLI::App* part) {
        part->add_option("--out", command.out, "folder for what is written")->capture_default_str();
    };
    const auto measures = [&](CLI::App* part) {
        writes(part);
        part->add_flag_callback(
            "--quick", [&command] { command.effort = Effort::quick; },
            "fewer queries: all parts in under ten minutes");
    };
    command.all = app.add_subcommand("all", "every part below, and a report of them: report.html");
    measures(command.all);
    command.all->add_flag("--go-on", command.go_on, "leave out the parts whose CSV is in the folder");
    for (const std::unique_ptr<Part>& part : parts) {
        command.parts.push_back(app.add_subcommand(std::string(part->name()), std::string(part->about())));
        part->describe(*command.parts.back());
        measures(command.parts.back());
    }
    command.record = app.add_subcommand(
        "record", "queries of a rubble pile hit by fast projectiles, simulated by Bullet: rubble.txt");
    command.record->add_option("--seed", command.rubble.seed, "of stones and shots")->capture_default_str();
    writes(command.record);
    command.compare = app.add_subcommand(
        "compare", "what got slower or less exact between two folders of results, each held "
                   "against the rivals of its own run");
    command.compare->add_option("old", command.before, "folder")->required();
    command.compare->add_option("new", command.after, "folder")->required();
}

/// What is wrong, and what would be right.
int explain(const CLI::App& app, std::string_view wrong)
{
    fmt::print(stderr, "brink-bench: {}\n\n", wrong);
    fmt::print(stderr, "{}", app.help("", CLI::AppFormatMode::All));
    return bad_input;
}

/// What was asked for, but for the folder.
std::string asked(int argc, char** argv)
{
    std::string text = "brink-bench";
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--out")
            ++i;
        else if (!word.starts_with("--out="))
            text += fmt::format(" {}", word);
    }
    return text;
}

int run(const Command& command, const Order& order, const std::vector<std::unique_ptr<Part>>& parts)
{
    if (command.compare->parsed()) return compare(command.before, command.after) == 0 ? 0 : got_worse;
    const Output output(command.out);
    std::uint64_t broken = 0;
    if (command.all->parsed()) broken = run_all(output, order, command.go_on ? Parts::missing : Parts::all);
    if (command.record->parsed()) run_record(output, command.rubble);
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (command.parts[i]->parsed()) broken = run_part(*parts[i], output, order);
    return broken == 0 ? 0 : broke_a_promise;
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("What brink finds, and how fast, beside its rivals", "brink-bench");
    const std::vector<std::unique_ptr<Part>> parts = all_parts();
    Command command;
    describe(app, command, parts);
    try {
        app.parse(argc, argv);
        if (app.get_subcommands().empty()) return explain(app, "which part?");
        return run(command, {asked(argc, argv), command.effort}, parts);
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        return explain(app, error.what());
    } catch (const std::exception& error) {
        fmt::print(stderr, "brink-bench: {}\n", error.what());
        return bad_input;
    }
}
