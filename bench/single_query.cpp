// SPDX-License-Identifier: BSD-3-Clause
#include "single_query.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

namespace brink::bench {
namespace {

using Ask = std::function<void(std::size_t)>;

/// ns of each query with its two readings of the clock.
std::vector<double> one_pass(std::size_t count, const Ask& ask)
{
    using Clock = std::chrono::steady_clock;
    std::vector<double> times(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto start = Clock::now();
        ask(i);
        const auto end = Clock::now();
        times[i] = std::chrono::duration<double, std::nano>(end - start).count();
    }
    return times;
}

} // namespace

double at_share(std::vector<double> values, double share)
{
    const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
}

std::vector<double> single_query_times(std::size_t count, const Ask& ask)
{
    const double clock = at_share(one_pass(count, [](std::size_t) {}), 0.5);
    const std::array passes{one_pass(count, ask), one_pass(count, ask), one_pass(count, ask)};
    std::vector<double> times(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::array three{passes[0][i], passes[1][i], passes[2][i]};
        std::sort(three.begin(), three.end());
        times[i] = three[1] - clock;
    }
    return times;
}

Spread single_queries(std::size_t count, const Ask& ask)
{
    const std::vector<double> times = single_query_times(count, ask);
    return {at_share(times, 0.5), at_share(times, 0.99)};
}

} // namespace brink::bench
