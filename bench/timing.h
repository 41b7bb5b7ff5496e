// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace brink::bench {

/// One measured figure: the mean over the repetitions of the processor time per query. Fields that were not
/// measured are 0.
struct Timing {
    std::string pair;
    std::string turning; // "none", "60" or "300": of either body, degrees at most
    std::string who;     // "baseline", "x86-64-v3" or "FCL"
    std::string what;    // "mixed", "hits", "misses" or "mixed time_only"
    double ns = 0;
    double deviation = 0;    // standard deviation between repetitions, ns
    double p50 = 0, p99 = 0; // of single queries, ns
    double calls = 0;        // distance evaluations per query, mean
    int most_calls = 0;      // of any query
    int undecided = 0;       // answers
    int queries = 0;         // distinct ones in each repetition
    int repetitions = 0;
};

/// Null where there is none such.
const Timing* find(const std::vector<Timing>&, std::string_view pair, std::string_view turning,
                   std::string_view who, std::string_view what);

std::string timings_csv(const std::vector<Timing>&);
/// The inverse of timings_csv; lines that are none are left out.
std::vector<Timing> parse_timings(std::string_view csv);

} // namespace brink::bench
