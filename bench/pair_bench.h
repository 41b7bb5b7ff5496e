// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace brink::bench {

/// One measured figure: the mean over the repetitions of the processor time per query.
struct Timing {
    std::string pair;
    std::string who;  // "baseline", "x86-64-v3" or "FCL"
    std::string what; // "mixed", "hits", "misses", "mixed time_only" or "rotating"
    double ns = 0;
    double deviation = 0; // standard deviation between repetitions, ns
    int queries = 0;      // distinct ones in each repetition
    int repetitions = 0;
};

enum class Rivals : unsigned char { none, fcl };

/// Measures this program's build of brink on every sample of the pairs named (pair_names), and FCL beside it
/// if asked, their repetitions interleaved at random so that both see the same machine.
std::vector<Timing> measure_pairs(Rivals, const std::vector<std::string>& names);

std::string timings_csv(const std::vector<Timing>&);
/// The inverse of timings_csv; lines that are none are left out.
std::vector<Timing> parse_timings(std::string_view csv);

} // namespace brink::bench
