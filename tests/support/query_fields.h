// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What a query consists of, once for those who write it down and those who read it.
namespace brink::support {

/// Where the numbers are, in the order in which they are written.
using Numbers = std::vector<double*>;

/// A shape's members, in order. Of a hull none: its points are written, not stored so.
Numbers numbers(Shape&);

struct Field {
    std::string_view name;
    Numbers numbers;
};
/// position, orientation (w, x, y, z), translation, rotation, pivot.
std::array<Field, 5> fields(Motion&);
/// Those of the options that are numbers with a point: t_max, target_gap, tolerance.
std::array<Field, 3> fields(Options&);

/// In the order of the enumerators.
inline constexpr std::array<std::string_view, 3> start_contact_names{"report", "ignore_if_separating",
                                                                     "ignore"};
inline constexpr std::array<std::string_view, 2> detail_names{"contact", "time_only"};

/// In hexadecimal, or as query_text.h says; no locale has a say.
std::string number_text(double);
/// The inverse, and decimal numbers; empty for what is no number, or none that a double holds.
std::optional<double> number_from(std::string_view text);

} // namespace brink::support
