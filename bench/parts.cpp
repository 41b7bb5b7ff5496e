// SPDX-License-Identifier: BSD-3-Clause
#include "part.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace brink::bench {

void add_choice(CLI::App& command, const std::string& option, std::vector<std::string>& value,
                std::vector<std::string> names)
{
    names.emplace_back("all");
    command.add_option(option, value, "which, separated by commas")
        ->delimiter(',')
        ->check(CLI::IsMember(std::move(names)))
        ->capture_default_str();
}

std::vector<std::string> chosen(const std::vector<std::string>& value, std::vector<std::string> names)
{
    if (std::find(value.begin(), value.end(), "all") != value.end()) return names;
    std::erase_if(
        names, [&](const std::string& n) { return std::find(value.begin(), value.end(), n) == value.end(); });
    return names;
}

std::vector<std::unique_ptr<Part>> all_parts()
{
    std::vector<std::unique_ptr<Part>> parts;
    parts.push_back(tunnelling_part());
    parts.push_back(error_part());
    parts.push_back(pairs_part());
    parts.push_back(scene_part());
    parts.push_back(replay_part());
    parts.push_back(ingredients_part());
    parts.push_back(stability_part());
    parts.push_back(turning_part());
    return parts;
}

} // namespace brink::bench
