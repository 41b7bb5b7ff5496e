// SPDX-License-Identifier: BSD-3-Clause
#include "scene_threads.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

namespace brink::bench {

bool have_threads() { return true; }

void with_threads(int threads, const std::function<void()>& work)
{
    using tbb::global_control;
    const global_control limit(global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    arena.execute(work);
}

} // namespace brink::bench
