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
std::atomic<std::size_t> bytes = 0; // that were asked for, given back or not

void* counted(std::size_t size, std::size_t alignment)
{
    ++allocations;
    bytes += size;
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
    bytes += size;
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
        const auto count = [&sum](const auto&) { return sum += 1, infinity; };
        const Scene::VisitorOf<RayImpact> ray_visitor = count;
        const Scene::VisitorOf<BodyPair> pair_visitor = count;
        const Scene::VisitorOf<SafeTime> halt_visitor = count;
        const auto step = [&](int i) {
            scene.set_motions(movers, motions[i % 4]);
            sum += static_cast<double>(scene.impacts().found.size());
            sum += scene.first_impact().toi.t;
            sum += static_cast<double>(scene.safe_times().size() + scene.candidates().size());
            sum += static_cast<double>(scene.overlapping().found.size());
            scene.visit_impacts(visitor);
            scene.visit_cast(Sphere{0.1}, motions[i % 4].front(), visitor);
            scene.visit_ray({0, 0, 0}, {1, 2, 3}, ray_visitor, 10);
            scene.visit_overlapping(pair_visitor);
            scene.visit_safe_times(halt_visitor);
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

TEST_CASE("scene: a million bodies at one point take bounded memory, and can be left at any time")
{
    constexpr std::size_t n = 1'000'000, enough = 2'000'000;
    Scene scene;
    for (std::size_t i = 0; i < n; ++i)
        scene.add({Sphere{0.5}});
    scene.update();
    const std::size_t before = bytes;
    std::size_t told = 0;
    const auto stop = [&](const auto&) { return ++told < enough ? 1.0 : -1.0; };
    alone([&] {
        scene.visit_impacts(stop);
        CHECK(told == enough);
        told = 0;
        scene.visit_overlapping(stop);
        CHECK(told == enough);
        told = 0;
        scene.visit_cast(Sphere{1}, {}, stop);
        CHECK(told == n);
        SceneOptions few;
        few.max_tests = 1000;
        CHECK(scene.overlapping(few).found.size() == 1000);
        CHECK(!scene.overlapping(few).complete);
        CHECK(scene.impacts(few).found.size() == 1000);
        CHECK(scene.first_impact().b == 1);
        CHECK(scene.ray_cast({-3, 0, 0}, {1, 0, 0}, 9, few).hit.status == Status::undecided);
    });
    CHECK(bytes - before < enough * sizeof(Impact) / 2); // not even of what was told, let alone of all pairs
}
