// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "part.h"

namespace brink::bench {

enum class Parts : unsigned char { all, missing }; // missing: those whose CSV is not in the folder

/// Runs the parts one after the other, each to the end even where one before it failed. After each writes
/// report.html of all that is in the folder by then, so that nothing finished is lost to an interruption.
/// Gives how many answers broke a promise.
std::uint64_t run_all(const Output&, Effort, Parts);

} // namespace brink::bench
