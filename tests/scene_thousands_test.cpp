// SPDX-License-Identifier: BSD-3-Clause
// Every scene against brute force over all pairs, bit for bit: of thousands of bodies, with each layer on and
// off, and on any number of threads.
#include "parallel.h"
#include "scene_brute.h"
#include "scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <thread>

#if BRINK_HAVE_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

using namespace brink;
using support::draw_model;
using support::same;
using support::SceneModel;

namespace {

constexpr std::size_t many = 3000, some = 1000;

void check_equal(std::span<const Impact> got, const std::vector<Impact>& want)
{
    REQUIRE(got.size() == want.size());
    std::size_t differ = 0;
    for (std::size_t i = 0; i < want.size(); ++i)
        differ += !same(got[i], want[i]);
    CHECK(differ == 0);
}

/// All impacts, the first and a visit.
void check_impacts(Scene& scene, const std::vector<Impact>& want, const SceneOptions& options = {})
{
    const Impacts all = scene.impacts(options);
    check_equal(all.found, want);
    CHECK(all.complete);
    const Impact first = scene.first_impact(options);
    if (want.empty())
        CHECK(first.toi.status == Status::separated);
    else
        CHECK(same(first, want.front()));
    std::vector<Impact> told;
    scene.visit_impacts(
        [&](const Impact& impact) {
            told.push_back(impact);
            return infinity;
        },
        options);
    std::sort(told.begin(), told.end(), [](const Impact& x, const Impact& y) {
        if (x.toi.t != y.toi.t) return x.toi.t < y.toi.t;
        return x.a != y.a ? x.a < y.a : x.b < y.b;
    });
    check_equal(told, want);
}

#if BRINK_HAVE_TBB
/// How many threads take part in this arena's work.
int threads_at_work()
{
    std::atomic<std::uint32_t> seen = 0;
    for_each_part(
        64,
        [&](std::size_t) {
            seen |= 1U << static_cast<unsigned>(tbb::this_task_arena::current_thread_index());
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        },
        1);
    return std::popcount(seen.load());
}
#endif

} // namespace

TEST_CASE("scene: 3,000 bodies of every scene are answered as brute force answers, on 1 to 16 threads")
{
    std::size_t impacts = 0;
    for (const std::string_view name : support::scene_names) {
        CAPTURE(name);
        const SceneModel model = draw_model(name, many, 17);
        const std::vector<Impact> want = model.impacts();
        impacts += want.size();
        Scene alone = support::scene_of(model);
        check_impacts(alone, want);
#if BRINK_HAVE_TBB
        const std::span<const SafeTime> safe = alone.safe_times();
        alone.impacts();
        const Ledger ledger = alone.ledger();
        // As many threads as are asked for, even where there are fewer cores.
        const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 16);
        for (const int threads : {1, 2, 3, 4, 8, 16}) {
            CAPTURE(threads);
            tbb::task_arena arena(threads);
            arena.execute([&] {
                CHECK(threads_at_work() > threads / 2);
                Scene scene = support::scene_of(model);
                check_impacts(scene, want);
                scene.impacts();
                CHECK(scene.ledger().removed == ledger.removed);
                CHECK(scene.ledger().exact == ledger.exact);
                const std::span<const SafeTime> times = scene.safe_times();
                CHECK(std::equal(
                    times.begin(), times.end(), safe.begin(), safe.end(),
                    [](const SafeTime& x, const SafeTime& y) { return x.body == y.body && x.t == y.t; }));
            });
        }
#endif
    }
    CHECK(impacts > many);
}

TEST_CASE("scene: 1,000 bodies of every scene are answered the same whichever layers are switched off")
{
    std::size_t impacts = 0, masked = 0, filtered = 0;
    for (const std::string_view name : support::scene_names) {
        SceneModel model = draw_model(name, some, 31);
        for (BodyId i = 0; i < model.bodies.size(); ++i) {
            model.bodies[i].category = i % 3 == 0 ? 2 : 1;
            model.bodies[i].mask = i % 5 == 0 ? 1 : 3;
        }
        model.filter = [](BodyId a, BodyId b) { return (a + b) % 7 != 0; };
        const std::vector<Impact> want = model.impacts();
        impacts += want.size();
        Scene scene = support::scene_of(model);
        check_impacts(scene, want);
        masked += scene.ledger().by(Layer::mask);
        filtered += scene.ledger().by(Layer::filter);
        for (int k = 0; k <= layer_count; ++k) {
            CAPTURE(name);
            CAPTURE(k);
            SceneOptions options;
            options.without = static_cast<Layer>(k);
            check_impacts(scene, want, options);
            options.without = options.without | Layer::simd | Layer::spheres | Layer::receding | Layer::late;
            check_impacts(scene, want, options);
        }
    }
    CHECK(impacts > some);
    CHECK(masked > 100);
    CHECK(filtered > 100);
}
