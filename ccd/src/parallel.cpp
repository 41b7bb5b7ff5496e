// SPDX-License-Identifier: BSD-3-Clause
#include "parallel.h"

#if BRINK_HAVE_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

namespace brink {

namespace {

void in_order(std::size_t begin, std::size_t end, const PartTask& task)
{
    for (std::size_t i = begin; i < end; ++i)
        task(i);
}

} // namespace

#if BRINK_HAVE_TBB
void for_each_part(std::size_t count, PartTask task, std::size_t grain)
{
    if (count <= grain) return in_order(0, count, task); // a few need no threads
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                      [&](const auto& range) { in_order(range.begin(), range.end(), task); });
}
#else
void for_each_part(std::size_t count, PartTask task, std::size_t) { in_order(0, count, task); }
#endif

} // namespace brink
