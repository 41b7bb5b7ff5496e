// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pair_sample.h"
#include "timing.h"

#include <string>
#include <vector>

namespace brink::bench {

/// Pairs in translation: both builds, each sample, FCL and how many times longer it takes. Both are
/// empty where no pair of theirs was measured.
std::string translation_table(const std::vector<Timing>&);
/// Pairs that turn.
std::string turning_table(const std::vector<Timing>&, Turning);

} // namespace brink::bench
