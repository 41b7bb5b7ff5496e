// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brink::bench {

/// A table as the parts write it: a first line of names, commas between, no quotes.
class Csv {
public:
    /// Throws std::invalid_argument, naming the line, where a row has not as many cells as there are names.
    explicit Csv(std::string_view text);

    std::size_t rows() const { return cells_.size(); }
    /// Throws std::invalid_argument, naming the column, where there is none of that name.
    const std::string& text(std::size_t row, std::string_view column) const;
    /// Likewise, and where the cell holds no number.
    double number(std::size_t row, std::string_view column) const;
    std::int64_t count(std::size_t row, std::string_view column) const;

private:
    std::map<std::string, std::size_t, std::less<>> columns_;
    std::vector<std::vector<std::string>> cells_;
};

/// Empty where there is no such file. Throws std::invalid_argument, naming the file, where it is no table.
std::optional<Csv> read_csv(const std::filesystem::path&);

} // namespace brink::bench
