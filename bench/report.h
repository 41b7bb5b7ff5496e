// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "part.h"

namespace brink::bench {

enum class Parts : unsigned char { all, missing }; // missing: those whose CSV is not in the folder

/// How the program was called.
struct Order {
    std::string command; // to note in the folder
    Effort effort = Effort::usual;
};

/// Runs one part, after noting in the folder on what and by which command it is measured.
std::uint64_t run_part(Part&, const Output&, const Order&);

/// Runs the parts one after the other, each to the end even where one before it failed, and prints the
/// summary. After each writes report.html of all that is in the folder by then, so that nothing finished is
/// lost to an interruption. Gives how many answers broke a promise.
std::uint64_t run_all(const Output&, const Order&, Parts);

} // namespace brink::bench
