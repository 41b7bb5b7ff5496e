// SPDX-License-Identifier: BSD-3-Clause
#include "scene_figures.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <numeric>

#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
#include <malloc.h>
#endif

namespace brink::bench {

const SceneFigures* find(const std::vector<SceneFigures>& figures, std::string_view scene,
                         std::string_view order, std::string_view who, int threads, std::size_t n)
{
    const auto found = std::find_if(figures.begin(), figures.end(), [&](const SceneFigures& f) {
        return f.scene == scene && f.order == order && f.who == who && f.threads == threads && f.n == n;
    });
    return found == figures.end() ? nullptr : &*found;
}

double read_bandwidth()
{
    const std::vector<std::uint64_t> words(std::size_t{1} << 26U, 1);
    double best = 0;
    for (int pass = 0; pass < 5; ++pass) {
        const auto begin = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(std::accumulate(words.begin(), words.end(), std::uint64_t{0}));
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
        best = std::max(best, static_cast<double>(words.size() * sizeof words[0]) / time.count());
    }
    return best;
}

double floor_ms(const SceneFigures& f, double bandwidth)
{
    const double bytes = (128.0 + 24.0) * static_cast<double>(f.movers) + 8.0 * static_cast<double>(f.pairs);
    return 1e3 * bytes / bandwidth;
}

std::size_t heap_bytes()
{
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
#else
    return 0;
#endif
}

} // namespace brink::bench
