// SPDX-License-Identifier: BSD-3-Clause
#include "moving.h"
#include "scenes.h"

#include <brink/overlap.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

#if BRINK_HAVE_TBB
#include <tbb/task_arena.h>
#endif

using namespace brink;

namespace {

std::atomic<long> allocations = 0;
std::atomic<std::size_t> bytes = 0;   // that were asked for, given back or not
std::atomic<long> until_refused = -1; // so many allocations are granted yet; negative: all

void* counted(std::size_t size, std::size_t alignment)
{
    ++allocations;
    bytes += size;
    if (until_refused >= 0 && until_refused-- == 0) throw std::bad_alloc();
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

// The whole program's, so that nothing goes uncounted. g++ 12 warns where it inlines delete and not new (at
// -O1).
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
[[gnu::noinline]] void operator delete(void* at) noexcept { std::free(at); }
[[gnu::noinline]] void operator delete(void* at, const std::nothrow_t&) noexcept { std::free(at); }
[[gnu::noinline]] void operator delete(void* at, std::size_t) noexcept { std::free(at); }
[[gnu::noinline]] void operator delete(void* at, std::align_val_t) noexcept { std::free(at); }
[[gnu::noinline]] void operator delete(void* at, std::size_t, std::align_val_t) noexcept { std::free(at); }

TEST_CASE("scene: a step like the one before allocates nothing")
{
    for (const std::string_view name : support::scene_names) {
        CAPTURE(name);
        const support::SceneSample sample = support::draw_scene(name, 1000, 11);
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

TEST_CASE("scene: safe times of 250,000 bodies at one point take bounded memory, and can be left")
{
    constexpr std::size_t n = 250'000;
    Scene scene;
    for (std::size_t i = 0; i < n; ++i)
        scene.add({Sphere{0.5}, support::moving({0, 0, 0}, {1, 0, 0})});
    scene.add({Sphere{0.5}, support::moving({9, 0, 0}, {1, 0, 0})}); // and one that goes on
    scene.update();
    const std::size_t before = bytes;
    alone([&] {
        std::size_t told = 0;
        scene.visit_safe_times([&](const SafeTime&) { return ++told, -1.0; });
        CHECK(told == 1);
        SceneOptions few;
        few.max_tests = 10;
        const std::span<const SafeTime> times = scene.safe_times(few);
        REQUIRE(times.size() == n + 1);
        CHECK(std::all_of(times.begin(), times.end() - 1, [](const SafeTime& s) { return s.t == 0; }));
        CHECK(times.back().t == 1);
        CHECK(scene.ledger().exact + scene.ledger().again <= 10);
    });
    // Asked for in all; the first contacts of the fewest bodies here would be 600,000 bytes for each.
    CHECK(bytes - before < 2000 * n);
}

TEST_CASE("scene: where memory runs out, nothing is lost")
{
    const auto body = [](int i) {
        Body b{Sphere{0.6}, support::moving({1.0 * i, 0, 0}, {0, 0, 0})};
        b.asleep = i % 4 == 0;
        return b;
    };
    int refused = 0;
    /// Whether there was memory enough.
    const auto with_memory_for = [&](long more, const auto& work) {
        until_refused = more;
        try {
            work();
        } catch (const std::bad_alloc&) {
            until_refused = -1;
            ++refused;
            return false;
        }
        until_refused = -1;
        return true;
    };
    const int n = 40;
    alone([&] {
        for (long more = 0;; ++more) { // while it is asked, and then changed in every way
            CAPTURE(more);
            Scene scene;
            for (int i = 0; i < n; ++i)
                scene.add(body(i));
            const bool enough = with_memory_for(more, [&] { scene.impacts(); });
            if (more % 2 == 0) CHECK(scene.impacts().found.size() == n - 1);
            const BodyId last = scene.add(body(n));
            scene.remove(1);
            scene.set_motion(4, support::moving({1e3, 0, 0}, {0, 0, 0}));
            scene.set_motion(6, support::moving({2e3, 0, 0}, {0, 0, 0}));
            scene.sleep(2);
            scene.wake(8);
            scene.add({HalfSpace{{0, 0, 1}, -0.5}});
            CHECK(scene.impacts().found.size() == n - 6 + n);
            CHECK(scene.swept_bounds(last).max.x() < n + 1);
            if (enough) break;
        }
        for (long more = 0;; ++more) { // while it changes
            CAPTURE(more);
            Scene scene;
            int there = 0;
            bool enough = true;
            for (int i = 0; i < n; ++i) {
                const bool added = with_memory_for(i < 20 ? -1 : more, [&] { scene.add(body(i)); });
                there += added ? 1 : 0;
                enough = enough && added;
                if (i == 10) CHECK(scene.impacts().found.size() == 10);
            }
            for (BodyId id = 0; id < scene.size(); id += 3)
                enough = with_memory_for(more, [&] { scene.sleep(id); }) && enough;
            for (BodyId id = 0; id < scene.size(); id += 4)
                enough = with_memory_for(more,
                                         [&] {
                                             Motion motion = scene.body(id).motion;
                                             motion.start.position.y() = 1e-3;
                                             scene.set_motion(id, motion);
                                         }) &&
                         enough;
            CHECK(scene.size() == static_cast<std::size_t>(there));
            std::size_t pairs = 0;
            for (BodyId id = 1; id < scene.size(); ++id) {
                const Body &a = scene.body(id - 1), &b = scene.body(id);
                pairs +=
                    !(a.asleep && b.asleep) && overlaps(a.shape, a.motion.start, b.shape, b.motion.start);
            }
            CHECK(scene.impacts().found.size() == pairs);
            if (enough) break;
        }
    });
    CHECK(refused > 20);
}
