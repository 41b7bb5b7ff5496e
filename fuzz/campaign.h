// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tally.h"

#include <vector>

namespace brink::fuzz {

struct Plan {
    std::vector<Pair> pairs;
    std::uint64_t cases = 20'000; // a pair
    std::uint64_t seed = 1;
    std::uint64_t first = 0;
    int threads = 1;
    std::uint64_t ask_every = 1;  // every which case brink is asked in other ways too; suspicious ones always
    std::uint64_t rule_every = 1; // every which case the referee judges; suspicious ones, and those that the
                                  // judge in doubles does not acquit, always
    std::uint64_t digits_every = 500; // every which case it finds the contact of in 100 digits (closed forms
                                      // in 200 too); disputed and undecided ones always
    std::uint64_t reference_every = 16; // every which case the reference judges; suspicious ones always
    std::uint64_t witness_every = 16;   // every which case FCL and libccd are asked
};

struct Outcome {
    std::vector<Tally> tallies; // in the order of plan.pairs
    bool stopped = false;       // by SIGINT
    std::uint64_t next = 0;     // every pair is done up to this index: --first to go on from
};

/// Runs the plan, with progress on stderr. All pairs advance together, in blocks, so that a campaign that is
/// stopped can go on from one index.
Outcome run(const Plan&);

/// One case on trial, every judge asked: what `brink-fuzz show` prints.
std::string show(const Pair&, std::uint64_t seed, std::uint64_t index);

} // namespace brink::fuzz
