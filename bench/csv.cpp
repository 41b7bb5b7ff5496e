// SPDX-License-Identifier: BSD-3-Clause
#include "csv.h"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace brink::bench {
namespace {

std::vector<std::string> split(std::string_view text, char by)
{
    std::vector<std::string> out;
    for (std::size_t end = 0; end != std::string_view::npos; text.remove_prefix(end + 1)) {
        end = text.find(by);
        out.emplace_back(text.substr(0, end));
        if (end == std::string_view::npos) break;
    }
    return out;
}

template <class Number> Number read(const std::string& cell, std::string_view column)
{
    Number out{};
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), out);
    if (error != std::errc() || end != cell.data() + cell.size())
        throw std::invalid_argument(fmt::format("'{}' in column '{}' is no number", cell, column));
    return out;
}

} // namespace

Csv::Csv(std::string_view text)
{
    std::vector<std::string> lines = split(text, '\n');
    if (lines.back().empty()) lines.pop_back();
    if (lines.empty()) throw std::invalid_argument("line 1: a line of names is missing");
    for (const std::string& name : split(lines.front(), ','))
        columns_.emplace(name, columns_.size());
    for (std::size_t i = 1; i < lines.size(); ++i) {
        cells_.push_back(split(lines[i], ','));
        if (cells_.back().size() != columns_.size())
            throw std::invalid_argument(fmt::format("line {}: {} cells where the first line names {}", i + 1,
                                                    cells_.back().size(), columns_.size()));
    }
}

const std::string& Csv::text(std::size_t row, std::string_view column) const
{
    const auto found = columns_.find(column);
    if (found == columns_.end()) throw std::invalid_argument(fmt::format("there is no column '{}'", column));
    return cells_.at(row)[found->second];
}

double Csv::number(std::size_t row, std::string_view column) const
{
    return read<double>(text(row, column), column);
}

std::int64_t Csv::count(std::size_t row, std::string_view column) const
{
    return read<std::int64_t>(text(row, column), column);
}

std::optional<Csv> read_csv(const std::filesystem::path& path)
{
    std::ifstream file(path);
    if (!file) return std::nullopt;
    std::stringstream text;
    text << file.rdbuf();
    try {
        return Csv(text.str());
    } catch (const std::invalid_argument& wrong) {
        throw std::invalid_argument(
            fmt::format("'{}' is no table of brink-bench: {}", path.string(), wrong.what()));
    }
}

} // namespace brink::bench
