// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace brink::bench {

struct Spread {
    double p50 = 0, p99 = 0; // ns that half, and 99 in 100, of the queries do not exceed
};

/// Asks each of `count` queries alone, between two readings of the steady clock, in three passes over all of
/// them. A query's time is the middle one of its three, so that an interrupt counts for none, less what the
/// clock itself takes: the median over as many readings with nothing asked.
Spread single_queries(std::size_t count, const std::function<void(std::size_t)>& ask);

} // namespace brink::bench
