// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace brink::bench {

struct Spread {
    double p50 = 0, p99 = 0; // ns that half, and 99 in 100, of the queries do not exceed
};

/// Asks each of `count` queries alone, between two readings of the steady clock, in three passes over all of
/// them. A query's time (ns) is the middle one of its three, so that an interrupt counts for none, less what
/// the clock itself takes: the median over as many readings with nothing asked.
std::vector<double> single_query_times(std::size_t count, const std::function<void(std::size_t)>& ask);

/// What their times come to.
Spread single_queries(std::size_t count, const std::function<void(std::size_t)>& ask);

/// The value that so large a share of them do not exceed; of one value at least.
double at_share(std::vector<double> values, double share);

} // namespace brink::bench
