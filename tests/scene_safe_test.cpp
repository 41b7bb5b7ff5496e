// SPDX-License-Identifier: BSD-3-Clause
#include "scene_brute.h"
#include "scenes.h"

#include <brink/distance.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

using namespace brink;
using support::SceneModel;

namespace {

/// Where a body is at t when it halts at `halt`.
Pose pose_at(const Body& b, double halt, double t) { return b.motion.at(std::min(t, halt)); }

bool rests(const Body& b) { return b.immovable || b.asleep; }

/// The least gap of any pair that is asked, at times all over the step; pairs that overlap at the start do
/// not count until they have been apart.
double least_gap(const SceneModel& model, std::span<const SafeTime> times, int samples, double target_gap = 0)
{
    double least = infinity;
    for (BodyId i = 0; i < model.bodies.size(); ++i) {
        for (BodyId k = i + 1; k < model.bodies.size(); ++k) {
            if (!model.asked(i, k)) continue;
            const Body &a = model.bodies[i], &b = model.bodies[k];
            bool apart = false;
            for (int s = 0; s <= samples; ++s) {
                const double t = static_cast<double>(s) / samples;
                const Distance d =
                    distance(a.shape, pose_at(a, times[i].t, t), b.shape, pose_at(b, times[k].t, t));
                apart = apart || d.gap > target_gap;
                if (apart) least = std::min(least, d.gap);
            }
        }
    }
    return least;
}

Body ball(double x, double speed)
{
    Body b{Sphere{0.5}, {}};
    b.motion.start.position = {x, 0, 0};
    b.motion.translation = {speed, 0, 0};
    return b;
}

} // namespace

TEST_CASE("scene: a queue that runs into a wall halts one behind the other")
{
    // A wall at x = 0 and ten balls of diameter 1 with gaps of 0.25, all at the same speed: alone, each meets
    // nothing but the first, because those in front of it go as fast.
    SceneModel model;
    Body wall{Box{{0.5, 5, 5}}, {}};
    wall.motion.start.position = {0.5, 0, 0};
    wall.immovable = true;
    model.bodies.push_back(wall);
    const int queue = 10;
    for (int k = 0; k < queue; ++k)
        model.bodies.push_back(ball(-1.0 - 1.25 * k, 16));
    Scene scene = support::scene_of(model);
    CHECK(scene.impacts().found.size() == 10); // each would reach the wall if it went on
    const std::span<const SafeTime> times = scene.safe_times();
    REQUIRE(times.size() == model.bodies.size());
    CHECK(times[0].t == 1);
    for (int k = 0; k < queue; ++k) {
        // Ball k halts with its front at -k: it has 0.5 + 0.25 k to go, at 16 a step.
        CAPTURE(k);
        const SafeTime& time = times[static_cast<std::size_t>(k) + 1];
        CHECK(time.t <= (0.5 + 0.25 * k) / 16);
        CHECK(time.t >= (0.5 + 0.25 * k) / 16 - 1e-12);
    }
    CHECK(least_gap(model, times, 400) >= -1e-12);
    CHECK(scene.ledger().again >= 9);
}

TEST_CASE("scene: what halts may stop what it would have made room for, and spare what it would have met")
{
    // A meets a wall at t = 0.25 and stands in the way of C, which would have passed behind it; B, which A
    // would have met at t = 0.75, goes on.
    SceneModel model;
    Body wall{Box{{0.5, 5, 5}}, {}};
    wall.motion.start.position = {3, 0, 0};
    wall.immovable = true;
    model.bodies = {wall, ball(0, 8), ball(0, 0), ball(0, 0)};
    model.bodies[2].motion.start.position = {
        1.4, -20, 0}; // C: would pass behind A; 1 from where that stands at y = -0.8
    model.bodies[2].motion.translation = {0, 40, 0};
    model.bodies[3].motion.start.position = {6, 10, 0}; // B: A would be here at t = 0.75
    model.bodies[3].motion.translation = {0, -13, 0};
    Scene scene = support::scene_of(model);
    const std::span<const SafeTime> times = scene.safe_times();
    CHECK(times[1].t == doctest::Approx(0.25));
    CHECK(times[2].t == doctest::Approx(0.48));
    CHECK(times[3].t == 1);
    CHECK(least_gap(model, times, 800) >= -1e-12);
}

TEST_CASE("scene: nothing overlaps when all halt at their safe times")
{
    std::size_t halted = 0, moving = 0;
    for (const std::string_view name : {"gas", "clustered", "bullets", "rain", "asleep"}) {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            CAPTURE(name);
            CAPTURE(seed);
            const SceneModel model = support::draw_model(name, 90, seed);
            Scene scene = support::scene_of(model);
            SceneOptions options;
            if (seed == 2) options.pair.target_gap = 0.01;
            const std::vector<SafeTime> times = [&] {
                const std::span<const SafeTime> t = scene.safe_times(options);
                return std::vector<SafeTime>(t.begin(), t.end());
            }();
            REQUIRE(times.size() == model.bodies.size());
            const std::vector<Impact> impacts = model.impacts(options.pair);
            const double first = impacts.empty() ? 1 : impacts.front().toi.t;
            for (const SafeTime& time : times) {
                CHECK(time.t >= first);
                CHECK(time.t <= 1);
                if (!rests(model.bodies[time.body])) (time.t < 1 ? halted : moving) += 1;
            }
            CHECK(least_gap(model, times, 60, options.pair.target_gap) >= options.pair.target_gap - 1e-9);
        }
    }
    CHECK(halted > 200);
    CHECK(moving > 100);
}

TEST_CASE("scene: safe times with a budget are earlier, never later")
{
    for (const std::string_view name : {"bullets", "rain"}) {
        const SceneModel model = support::draw_model(name, 150, 4);
        Scene scene = support::scene_of(model);
        for (const std::size_t budget : {0U, 5U, 50U}) {
            CAPTURE(name);
            CAPTURE(budget);
            SceneOptions options;
            options.max_tests = budget;
            const std::span<const SafeTime> times = scene.safe_times(options);
            CHECK(scene.ledger().exact + scene.ledger().again <= budget);
            CHECK(least_gap(model, times, 60) >= -1e-9);
        }
    }
}

TEST_CASE("scene: bodies in contact at the start follow start_contact")
{
    SceneModel model;
    model.bodies = {ball(0, 0), ball(0.9, 5), ball(8, 0)};
    Scene scene = support::scene_of(model);
    CHECK(scene.safe_times()[1].t == 0);
    SceneOptions options;
    options.pair.start_contact = StartContact::ignore_if_separating;
    const std::span<const SafeTime> leaving = scene.safe_times(options);
    CHECK(leaving[0].t == 1);
    CHECK(leaving[1].t == 1); // at 5.9 its front is at 6.4
    model.bodies[1] = ball(0.9, 8);
    Scene longer = support::scene_of(model);
    CHECK(longer.safe_times(options)[1].t == doctest::Approx(6.1 / 8));
    CHECK(longer.safe_times(options)[2].t == doctest::Approx(6.1 / 8));
}
