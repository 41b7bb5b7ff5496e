// SPDX-License-Identifier: BSD-3-Clause
// Visits and budgets of every question.
#include "random.h"
#include "scene_brute.h"
#include "scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

using namespace brink;
using support::draw_model;
using support::Random;
using support::SceneModel;

namespace {

bool before(BodyPair x, BodyPair y) { return x.a != y.a ? x.a < y.a : x.b < y.b; }
bool before(const Impact& x, const Impact& y)
{
    if (x.toi.t != y.toi.t) return x.toi.t < y.toi.t;
    return x.a != y.a ? x.a < y.a : x.b < y.b;
}
bool before(const RayImpact& x, const RayImpact& y)
{
    return x.hit.t != y.hit.t ? x.hit.t < y.hit.t : x.body < y.body;
}
bool same(BodyPair x, BodyPair y) { return x == y; }
bool same(const Impact& x, const Impact& y) { return support::same(x, y); }
bool same(const RayImpact& x, const RayImpact& y)
{
    return x.body == y.body && x.hit.t == y.hit.t && x.hit.point == y.hit.point;
}
double time(BodyPair) { return 0; }
double time(const Impact& x) { return x.toi.t; }
double time(const RayImpact& x) { return x.hit.t; }

template <class Result> bool all_same(std::span<const Result> got, const std::vector<Result>& want)
{
    return std::equal(got.begin(), got.end(), want.begin(), want.end(),
                      [](const Result& x, const Result& y) { return same(x, y); });
}

/// A visit held against what it is to tell, in order: whole, stopped, narrowed to the first, and with
/// budgets. Returns how many budgets ran out.
template <class Result, class Visit> int check_visit(const std::vector<Result>& want, const Visit& visit)
{
    std::vector<Result> told;
    const auto hear = [&](const SceneOptions& options, auto answer) {
        told.clear();
        const double open = visit(
            [&](const Result& r) {
                told.push_back(r);
                return answer();
            },
            options);
        std::sort(told.begin(), told.end(), [](const Result& x, const Result& y) { return before(x, y); });
        return open;
    };
    CHECK(hear({}, [] { return infinity; }) == infinity);
    CHECK(all_same(std::span<const Result>(told), want));
    const std::size_t few = std::min<std::size_t>(want.size(), 2);
    hear({}, [&] { return told.size() < few ? infinity : -1.0; });
    CHECK(told.size() == few);
    hear({}, [&] {
        return time(*std::min_element(told.begin(), told.end(),
                                      [](const Result& x, const Result& y) { return time(x) < time(y); }));
    });
    CHECK(told.empty() == want.empty());
    if (!want.empty()) CHECK(same(told.front(), want.front()));

    int spent = 0;
    for (const std::size_t budget : {0U, 1U, 2U, 5U, 20U, 100'000U}) {
        SceneOptions options;
        options.max_tests = budget;
        const double open = hear(options, [] { return infinity; });
        CHECK(told.size() <= budget);
        std::size_t known = 0; // those that must have been told
        for (const Result& r : want)
            known += time(r) < open;
        for (const Result& r : told)
            known -= time(r) < open;
        CHECK(known == 0);
        spent += open < infinity;
    }
    return spent;
}

struct Probe {
    Vec3 from, by;
};
Probe draw_probe(Random& random, const SceneModel& model)
{
    const auto i = static_cast<std::size_t>(random.index(static_cast<int>(model.bodies.size())));
    const Vec3 off = random.in_cube(2);
    const Vec3 by = random.in_cube(5);
    return {model.bodies[i].motion.start.position + off, by};
}

} // namespace

TEST_CASE("scene: a visit tells what the whole answer holds, until it is to stop or the budget is spent")
{
    int spent = 0, asked = 0;
    std::size_t results = 0;
    for (const std::string_view name : support::scene_names) {
        CAPTURE(name);
        const SceneModel model = draw_model(name, 250, 101);
        Scene scene = support::scene_of(model);
        results += model.overlapping().size();
        spent += check_visit(model.impacts(), [&](auto visitor, const SceneOptions& options) {
            return scene.visit_impacts(visitor, options);
        });
        spent += check_visit(model.overlapping(), [&](auto visitor, const SceneOptions& options) {
            return scene.visit_overlapping(visitor, options);
        });
        Random random(102);
        for (int k = 0; k < 20; ++k) {
            CAPTURE(k);
            const Probe p = draw_probe(random, model);
            Motion motion;
            motion.start.position = p.from;
            motion.translation = p.by;
            const Shape shape = k % 5 == 0 ? Shape{HalfSpace{{0, 0, 1}, -2}} : Shape{Sphere{0.5}};
            const std::vector<Impact> impacts = model.cast(shape, motion, {});
            spent += check_visit(impacts, [&](auto visitor, const SceneOptions& options) {
                return scene.visit_cast(shape, motion, visitor, options);
            });
            const double t_max = k % 3 == 0 ? infinity : 2;
            const std::vector<RayImpact> rays = model.rays(p.from, p.by, t_max);
            spent += check_visit(rays, [&](auto visitor, const SceneOptions& options) {
                return scene.visit_ray(p.from, p.by, visitor, t_max, options);
            });
            results += impacts.size() + rays.size();
            ++asked;
        }
    }
    CHECK(asked == 120);
    CHECK(results > 1000);
    CHECK(spent > 200);
}

TEST_CASE("scene: overlaps and rays within a budget are safe, and say whether they are whole")
{
    int whole = 0, cut = 0;
    for (const std::string_view name : {"gas", "stacks", "rain"}) {
        CAPTURE(name);
        const SceneModel model = draw_model(name, 300, 111);
        Scene scene = support::scene_of(model);
        const std::vector<BodyPair> want = model.overlapping();
        Random random(112);
        for (const std::size_t budget : {0U, 1U, 7U, 60U, 100'000U}) {
            SceneOptions options;
            options.max_tests = budget;
            const Overlaps some = scene.overlapping(options);
            CHECK(scene.ledger().exact <= budget);
            CHECK(std::includes(want.begin(), want.end(), some.found.begin(), some.found.end(),
                                [](BodyPair x, BodyPair y) { return before(x, y); }));
            if (some.complete) CHECK(some.found.size() == want.size());
            CHECK(some.complete == (scene.ledger().left == 0));
            for (int k = 0; k < 20; ++k) {
                CAPTURE(k);
                const Probe p = draw_probe(random, model);
                const std::vector<RayImpact> rays = model.rays(p.from, p.by, 3);
                const RayImpact first = scene.ray_cast(p.from, p.by, 3, options);
                CHECK(scene.ledger().exact <= budget);
                const double earliest = rays.empty() ? 3 : rays.front().hit.t;
                CHECK(first.hit.t <= earliest);
                if (first.hit.status != Status::undecided) CHECK(first.hit.t == earliest);
                if (first.hit.status == Status::undecided) CHECK(first.body == no_body);
                if (first.hit.status == Status::separated) CHECK(rays.empty());
                const RayImpacts all = scene.ray_cast_all(p.from, p.by, 3, options);
                std::size_t known = 0;
                for (const RayImpact& r : rays)
                    known += r.hit.t < all.known_until;
                for (const RayImpact& r : all.found)
                    known -= r.hit.t < all.known_until;
                CHECK(known == 0);
                if (all.complete) CHECK(all.found.size() == rays.size());
                if (all.complete) CHECK(all.known_until == 3);
                ++(all.complete ? whole : cut);
            }
        }
    }
    CHECK(whole > 50);
    CHECK(cut > 50);
}

TEST_CASE("scene: halts are told in the order of their times, and all until a time")
{
    std::size_t halts = 0;
    for (const std::string_view name : support::scene_names) {
        CAPTURE(name);
        const SceneModel model = draw_model(name, 300, 121);
        Scene scene = support::scene_of(model);
        const std::span<const SafeTime> safe = scene.safe_times();
        const std::vector<SafeTime> want(safe.begin(), safe.end());
        std::vector<double> told(want.size(), 1);
        double last = 0;
        scene.visit_safe_times([&](const SafeTime& s) {
            CHECK(s.t >= last);
            last = s.t;
            told[s.body] = s.t;
            ++halts;
            return 1.0;
        });
        for (std::size_t i = 0; i < want.size(); ++i)
            CHECK(told[i] == want[i].t);
        std::fill(told.begin(), told.end(), 1.0);
        scene.visit_safe_times([&](const SafeTime& s) {
            told[s.body] = s.t;
            return 0.3;
        });
        for (std::size_t i = 0; i < want.size(); ++i)
            if (want[i].t <= 0.3 || told[i] < 0.3) CHECK(told[i] == want[i].t);
        int heard = 0;
        scene.visit_safe_times([&](const SafeTime&) { return ++heard < 3 ? 1.0 : -1.0; });
        CHECK(heard <= 3);
    }
    CHECK(halts > 300);
}

TEST_CASE("scene: no visitor may change or ask the scene, whatever it is told of")
{
    Scene scene;
    scene.add({Sphere{1}});
    scene.add({Sphere{1}});
    const std::vector<std::function<void()>> acts{[&] { scene.add({Sphere{1}}); },
                                                  [&] { scene.remove(0); },
                                                  [&] { scene.replace(1, {Sphere{2}}); },
                                                  [&] { scene.set_motion(1, {}); },
                                                  [&] { scene.sleep(1); },
                                                  [&] { scene.wake(1); },
                                                  [&] { scene.set_filter({}); },
                                                  [&] { scene.update(); },
                                                  [&] { scene.overlapping(); },
                                                  [&] { scene.safe_times(); },
                                                  [&] {
                                                      scene.ray_cast({0, 0, 0}, {1, 0, 0});
                                                  },
                                                  [&] { scene.cast(Sphere{1}, {}); },
                                                  [&] { scene.candidates(); },
                                                  [&] { scene.first_impact(); }};
    for (std::size_t k = 0; k < acts.size(); ++k) {
        CAPTURE(k);
        const auto act = [&](const auto&) {
            acts[k]();
            return 1.0;
        };
        CHECK_THROWS_AS(scene.visit_impacts(act), std::logic_error);
        CHECK_THROWS_AS(scene.visit_cast(Sphere{1}, {}, act), std::logic_error);
        CHECK_THROWS_AS(scene.visit_overlapping(act), std::logic_error);
        CHECK_THROWS_AS(scene.visit_ray({0, 0, 0}, {1, 0, 0}, act), std::logic_error);
        CHECK_THROWS_AS(scene.visit_safe_times(act), std::logic_error);
    }
    CHECK(scene.size() == 2);
    CHECK(scene.overlapping().found.size() == 1);
    CHECK_THROWS_AS(scene.visit_overlapping({}), std::invalid_argument);
    CHECK_THROWS_AS(scene.visit_ray({0, 0, 0}, {1, 0, 0}, {}), std::invalid_argument);
    CHECK_THROWS_AS(scene.visit_cast(Sphere{1}, {}, {}), std::invalid_argument);
    CHECK_THROWS_AS(scene.visit_safe_times({}), std::invalid_argument);
}

TEST_CASE("scene: a visitor that answers NaN is told of nothing more")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Scene scene;
    for (int i = 0; i < 20; ++i)
        scene.add({Sphere{1}});
    int told = 0;
    const auto answer = [&](const auto&) { return ++told, nan; };
    scene.visit_impacts(answer);
    CHECK(told == 1);
    scene.visit_overlapping(answer);
    CHECK(told == 2);
    scene.visit_cast(Sphere{1}, {}, answer);
    CHECK(told == 3);
    scene.visit_cast(HalfSpace{}, {}, answer);
    CHECK(told == 4);
    scene.visit_ray({-5, 0, 0}, {9, 0, 0}, answer);
    CHECK(told == 5);
    scene.visit_safe_times(answer);
    CHECK(told == 6);
}
