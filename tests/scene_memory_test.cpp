// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.h"

#include <doctest/doctest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#if BRINK_HAVE_TBB
#include <tbb/task_arena.h>
#endif

using namespace brink;

namespace {

std::atomic<long> allocations = 0;

void* counted(std::size_t size, std::size_t alignment)
{
    ++allocations;
    const std::size_t whole = (size + alignment - 1) / alignment * alignment;
    if (void* at = std::aligned_alloc(alignment, whole == 0 ? alignment : whole)) return at;
    throw std::bad_alloc();
}

/// One thread: oneTBB's own needs are not a scene's.
template <class Work> void alone(Work work)
{
#if BRINK_HAVE_TBB
    tbb::task_arena(1).execute(work);
#else
    work();
#endif
}

} // namespace

// The whole program's, so that nothing goes uncounted.
void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment)
{
    return counted(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
    ++allocations;
    return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* at) noexcept { std::free(at); }
void operator delete(void* at, const std::nothrow_t&) noexcept { std::free(at); }
void operator delete(void* at, std::size_t) noexcept { std::free(at); }
void operator delete(void* at, std::align_val_t) noexcept { std::free(at); }
void operator delete(void* at, std::size_t, std::align_val_t) noexcept { std::free(at); }

TEST_CASE("scene: a step like the one before allocates nothing")
{
    for (const std::string_view name : support::scene_names) {
        CAPTURE(name);
        const support::SceneSample sample = support::draw_scene(name, 2000, 11);
        const std::vector<BodyId> movers = support::movers(sample);
        const std::vector<Motion> motions[] = {
            support::motions_at(sample, movers, 0), support::motions_at(sample, movers, 1),
            support::motions_at(sample, movers, 2), support::motions_at(sample, movers, 3)};
        Scene scene;
        for (const Body& body : sample.bodies)
            scene.add(body);
        double sum = 0;
        const Scene::Visitor visitor = [&](const Impact& impact) {
            sum += impact.toi.t;
            return 1.0;
        };
        const auto step = [&](int i) {
            scene.set_motions(movers, motions[i % 4]);
            sum += static_cast<double>(scene.impacts().found.size());
            sum += scene.first_impact().toi.t;
            sum += static_cast<double>(scene.safe_times().size() + scene.candidates().size());
            sum += static_cast<double>(scene.overlapping().found.size());
            scene.visit_impacts(visitor);
            sum += scene.cast(Sphere{0.1}, motions[i % 4].front()).toi.t;
            sum += scene.ray_cast({0, 0, 0}, {1, 2, 3}, 10).hit.t;
        };
        alone([&] {
            for (int i = 0; i < 8; ++i)
                step(i);
            const long before = allocations;
            CHECK(before > 0); // it does count
            for (int i = 0; i < 8; ++i)
                step(i);
            CHECK(allocations == before);
        });
        CHECK(sum > 0);
    }
}
