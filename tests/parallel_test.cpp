// SPDX-License-Identifier: BSD-3-Clause
#include "parallel.h"

#include <doctest/doctest.h>

#include <atomic>
#include <vector>

#if BRINK_HAVE_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

using namespace brink;

namespace {

/// How many of the indices are not called exactly once.
int missed(std::size_t count, std::size_t grain)
{
    std::vector<std::atomic<int>> calls(count + 1);
    for_each_part(
        count, [&](std::size_t i) { ++calls[std::min(i, count)]; }, grain);
    int wrong = calls[count] != 0;
    for (std::size_t i = 0; i < count; ++i)
        wrong += calls[i] != 1;
    return wrong;
}

int missed_in_all()
{
    int wrong = 0;
    for (const std::size_t count : {0U, 1U, 2U, 63U, 64U, 65U, 1000U, 100'000U})
        for (const std::size_t grain : {1U, 16U, 64U, 4096U})
            wrong += missed(count, grain);
    return wrong;
}

} // namespace

TEST_CASE("for_each_part: each index once, whatever the grain")
{
    CHECK(missed_in_all() == 0);
    std::size_t calls = 0;
    for_each_part(64, [&](std::size_t i) { calls += i + 1; }); // so few stay on this thread
    CHECK(calls == 64 * 65 / 2);
}

#if BRINK_HAVE_TBB
TEST_CASE("for_each_part: in the caller's arena, of one thread and of four")
{
    const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
    for (const int threads : {1, 4}) {
        tbb::task_arena arena(threads);
        CAPTURE(threads);
        CHECK(arena.execute(missed_in_all) == 0);
        std::atomic<int> elsewhere = 0, calls = 0;
        arena.execute([&] {
            for_each_part(
                10'000,
                [&](std::size_t) {
                    ++calls;
                    elsewhere += tbb::this_task_arena::max_concurrency() != threads;
                },
                1);
        });
        CHECK(calls == 10'000);
        CHECK(elsewhere == 0);
    }
}
#endif
