// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "part.h"

namespace brink::bench {

enum class Parts : unsigned char { all, missing }; // missing: those whose CSV is not in the folder

/// Runs one part, after noting in the folder what it is measured on.
std::uint64_t run_part(Part&, const Output&, Effort);

/// Runs the parts one after the other, each to the end even where one before it failed, and prints the
/// summary. After each writes report.html of all that is in the folder by then, so that nothing finished is
/// lost to an interruption. Gives how many answers broke a promise.
std::uint64_t run_all(const Output&, Effort, Parts);

} // namespace brink::bench
