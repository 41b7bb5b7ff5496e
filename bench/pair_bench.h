// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "part.h"
#include "timing.h"

#include <string>
#include <vector>

namespace brink::bench {

enum class Rivals : unsigned char { none, fcl };

/// Measures this program's build of brink on every sample of the pairs named (pair_names), and FCL beside it
/// if asked, their repetitions interleaved at random so that both see the same machine.
std::vector<Timing> measure_pairs(Rivals, const std::vector<std::string>& names, Effort);

} // namespace brink::bench
