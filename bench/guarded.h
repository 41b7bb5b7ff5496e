// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace brink::bench {

/// What came of one query that was asked where a crash does no harm.
struct Said {
    enum class Ending : unsigned char { unasked, answered, crashed, hung };
    Ending ending = Ending::unasked;
    bool contact = false;
    double t = 0;  // of the contact
    double ns = 0; // that the query took (single_query.h)
};

/// Asks queries 0 to count - 1 in a child process, once for the answers and then, those that answered, for
/// the times. A crash, or an answer that takes more than ten seconds, costs that query only. `ask` gives the
/// time of contact where it finds one. What it prints is lost. Throws std::runtime_error where there is no
/// process or memory to be had.
std::vector<Said> ask_guarded(std::size_t count,
                              const std::function<std::optional<double>(std::size_t)>& ask);

} // namespace brink::bench
