// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "stability_score.h"

#include <fcl_process.h>

namespace brink::bench {

/// Consecutive cases of one pair and class.
struct Block {
    support::Pair pair;
    Spot spot; // its step is ignored
    std::uint64_t seed = 0, begin = 0, end = 0;
};

/// FCL is asked every which case: it is slow, and where it hangs slower still.
inline constexpr std::uint64_t fcl_every = 20;

/// Whether this build can judge: Boost.Multiprecision and MPFR were there. Without them `measure` gives
/// nothing.
inline constexpr bool have_referee = BRINK_HAVE_REFEREE;

/// Everybody's answers to a block's cases, held against the referee.
Scores measure(const Block&, support::FclProcess&);

} // namespace brink::bench
