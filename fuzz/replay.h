// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "campaign.h"
#include "query_text.h"

#include <span>
#include <string>

namespace brink::fuzz {

/// Queries of a file before every judge there is, whatever brink answers; a case's index is its line.
/// `pairs` and `tallies` are of the pairs that occur, in the order of all_pairs(). Progress on stderr.
struct Replayed {
    std::vector<Pair> pairs;
    std::vector<Tally> tallies;
    bool stopped = false; // by SIGINT
};
Replayed replay(std::span<const support::KeptQuery>, int threads);

} // namespace brink::fuzz
