// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pair_bench.h"

#include <string>
#include <vector>

namespace brink::bench {

/// Closed-form pairs: both builds, each sample, FCL and how many times longer it takes. All three are empty
/// where no pair of theirs was measured.
std::string pairs_table(const std::vector<Timing>&);
/// Pairs that rotate, which advancement decides.
std::string rotating_table(const std::vector<Timing>&);
/// A gnuplot script, figures included, that draws the mixed closed-form pairs as bars.
std::string pairs_plot(const std::vector<Timing>&);

} // namespace brink::bench
