// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "stability_score.h"

#include <string>

namespace brink::bench {

/// A block for every pair, a row for every class of difficulty, all levels together.
std::string stability_table(const Scores&);

/// A row for every pair, class, level and solver.
std::string stability_csv(const Scores&);

} // namespace brink::bench
