// SPDX-License-Identifier: BSD-3-Clause
// Safe times of bodies that come back to each other, and of a great many at one place.
#include "moving.h"
#include "scene_brute.h"

#include <brink/distance.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace brink;
using support::moving;

namespace {

Body at(const Shape& shape, const Vec3& position, const Vec3& translation = {0, 0, 0})
{
    return {shape, moving(position, translation)};
}

Body immovable(Body body)
{
    body.immovable = true;
    return body;
}

double gap_at_halt(const Scene& scene, std::span<const SafeTime> times, BodyId a, BodyId b)
{
    const Body &x = scene.body(a), &y = scene.body(b);
    return distance(x.shape, x.motion.at(times[a].t), y.shape, y.motion.at(times[b].t)).gap;
}

/// A bar turns by half a turn; a ball that touches it at the start drops out of its way and is met by its
/// other half; a peg stops the bar at about that time, the later the lower it is.
struct Return {
    Body ball, bar, peg;
    SceneOptions options;

    Return(double far, double tolerance)
    {
        bar = at(Capsule{{-2, 0, 0}, {2, 0, 0}, 0.1}, {far, 0, 0});
        bar.motion.rotation = {0, 0, std::numbers::pi};
        ball = at(Sphere{0.2}, {far + 1.9, -0.29, 0}, {0, -0.5, 0});
        peg = immovable(at(Sphere{0.05}, {far - 1.4, 0, 0}));
        options.pair.tolerance = tolerance;
        options.pair.start_contact = StartContact::ignore;
    }
    double returned() const
    {
        return time_of_impact(ball.shape, ball.motion, bar.shape, bar.motion, options.pair).t;
    }
    double stopped(double height)
    {
        peg.motion.start.position.y() = height;
        return time_of_impact(bar.shape, bar.motion, peg.shape, peg.motion, options.pair).t;
    }
    /// The height at which the peg stops the bar as the ball is met.
    double tie()
    {
        const double then = returned();
        double low = 0.2, high = 1.2;
        for (int i = 0; i < 100; ++i) {
            const double middle = 0.5 * (low + high);
            (stopped(middle) < then ? high : low) = middle;
        }
        return high;
    }
};

} // namespace

TEST_CASE("scene: a contact that was left is no longer ignored when a third body halts the partner")
{
    struct Case {
        double far, tolerance, step;
    };
    int before = 0, after = 0;
    for (const Case& c : {Case{0, 0, 1.6e-16}, Case{1e5, 1e-9, 1e-11}, Case{1e5, 1e-9, 1e-10}}) {
        Return come_back(c.far, c.tolerance);
        const double tie = come_back.tie();
        for (int k = -100; k < 200; ++k) {
            const double stopped = come_back.stopped(tie + k * c.step);
            ++(stopped < come_back.returned() ? before : after);
            Scene scene;
            scene.add(come_back.ball);
            scene.add(come_back.bar);
            scene.add(come_back.peg);
            CAPTURE(c.far);
            CAPTURE(k);
            const std::span<const SafeTime> times = scene.safe_times(come_back.options);
            CHECK(gap_at_halt(scene, times, 0, 1) > -1e-9);
            CHECK(times[1].t <= stopped);
        }
    }
    CHECK(before > 200);
    CHECK(after > 100);
}

TEST_CASE("scene: a contact that lasts is still ignored when a third body halts the partner")
{
    for (const double lift : {0.0, -0.1}) { // touching, and within each other
        for (const StartContact how : {StartContact::ignore, StartContact::ignore_if_separating}) {
            CAPTURE(lift);
            CAPTURE(static_cast<int>(how));
            Scene scene;
            scene.add(at(Box{{1, 1, 1}}, {0, 0, 0}, {4, 0, 0}));
            scene.add(at(Box{{1, 1, 1}}, {0.25, 2 + lift, 0}, {4, 0, 0}));
            scene.add(immovable(at(Box{{1, 0.5, 1}}, {4, -0.25, 0})));
            SceneOptions options;
            options.pair.start_contact = how;
            const std::span<const SafeTime> times = scene.safe_times(options);
            CHECK(times[0].t == doctest::Approx(0.5));
            if (how == StartContact::ignore) CHECK(times[1].t == 1);
        }
    }
}

TEST_CASE("scene: halts of very many pairs are those of few")
{
    // More contacts than are kept at once, at times all over the step: the same bodies asked group by group.
    Scene all;
    std::vector<SafeTime> want;
    constexpr BodyId groups = 20, each = 60;
    for (BodyId g = 0; g < groups; ++g) {
        Scene one;
        for (BodyId i = 0; i < each; ++i) {
            const double angle = 2.4 * i + g, far = 2 + 0.13 * ((7 * i) % each);
            const Vec3 from = far * Vec3(std::cos(angle), std::sin(angle), 0.3 * std::sin(3 * angle));
            Body body = at(Sphere{0.1 + 0.001 * i}, from + Vec3(100.0 * g, 0, 0), -1.5 * from);
            all.add(body);
            one.add(body);
        }
        for (const SafeTime& s : one.safe_times())
            want.push_back({g * each + s.body, s.t});
    }
    CHECK(all.impacts().found.size() > 4 * groups * each + 4096); // what is kept
    const std::span<const SafeTime> got = all.safe_times();
    REQUIRE(got.size() == want.size());
    std::size_t halted = 0;
    for (std::size_t i = 0; i < want.size(); ++i) {
        CAPTURE(i);
        CHECK(got[i].body == want[i].body);
        CHECK(got[i].t == doctest::Approx(want[i].t).epsilon(1e-9));
        halted += got[i].t < 1;
    }
    CHECK(halted > 600);
    double last = 0;
    std::size_t told = 0;
    all.visit_safe_times([&](const SafeTime& s) {
        CHECK(s.t >= last);
        CHECK(s.t == got[s.body].t);
        last = s.t;
        ++told;
        return infinity;
    });
    CHECK(told >= halted);
}

TEST_CASE("scene: halts of very many bodies at one point, with any budget")
{
    constexpr BodyId n = 5000;
    Scene scene;
    for (BodyId i = 0; i < n; ++i)
        scene.add(at(Sphere{1}, {0, 0, 0}, {1, 0, 0}));
    scene.add(at(Sphere{1}, {0, 9, 0}, {1, 0, 0}));
    for (const std::size_t budget : {std::size_t{0}, std::size_t{10}, static_cast<std::size_t>(-1)}) {
        CAPTURE(budget);
        SceneOptions options;
        options.max_tests = budget;
        const std::span<const SafeTime> times = scene.safe_times(options);
        REQUIRE(times.size() == n + 1);
        CHECK(std::all_of(times.begin(), times.end() - 1, [](const SafeTime& s) { return s.t == 0; }));
        CHECK(times.back().t == 1);
        CHECK(scene.ledger().exact + scene.ledger().again <= std::min<std::size_t>(budget, 40 * n));
    }
}

TEST_CASE("scene: a body added, removed and added again leaves no cost behind but its id")
{
    Scene scene;
    scene.add(at(Sphere{1}, {0, 0, 0}));
    scene.add(at(Sphere{1}, {9, 0, 0}));
    for (int i = 0; i < 1000; ++i)
        scene.remove(scene.add(at(Sphere{1}, {4, 0, 0}, {1, 0, 0})));
    const BodyId last = scene.add(at(Sphere{1}, {6, 0, 0}, {-8, 0, 0}));
    scene.remove(1);
    scene.add(at(Sphere{1}, {9, 0, 0}));
    const std::span<const SafeTime> times = scene.safe_times();
    REQUIRE(times.size() == 3);
    CHECK(times[0].body == 0);
    CHECK(times[1].body == last);
    CHECK(times[1].t == 0.5);
    CHECK(times[2].body == last + 1);
}
