// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "stability_score.h"

#include <string>

namespace brink::bench {

/// A row for every class, all pairs and levels together, and one for every pair.
std::string turning_table(const Scores&);

/// A row for every pair, class, level and solver.
std::string turning_csv(const Scores&);

/// The scores of one class, of one of its levels, or of one pair.
Score pooled(const Scores&, Solver, bool (*)(const Spot&, const Spot& wanted), const Spot& wanted);

} // namespace brink::bench
