// SPDX-License-Identifier: BSD-3-Clause
#include "random.h"
#include "scene_brute.h"
#include "scenes.h"

#include <doctest/doctest.h>

#include <numeric>
#include <string>

using namespace brink;
using support::draw_model;
using support::same;
using support::SceneModel;

namespace {

void check_equal(std::span<const Impact> got, const std::vector<Impact>& want)
{
    REQUIRE(got.size() == want.size());
    for (std::size_t i = 0; i < want.size(); ++i) {
        CAPTURE(i);
        CAPTURE(want[i].a);
        CAPTURE(want[i].b);
        CHECK(same(got[i], want[i]));
    }
}

void check_first(const Impact& got, const std::vector<Impact>& want, double t_max)
{
    if (!want.empty()) {
        CHECK(same(got, want.front()));
        return;
    }
    CHECK(got.toi.status == Status::separated);
    CHECK(got.toi.t == t_max);
    CHECK(got.b == no_body);
}

/// Every pair is told of once.
void check_ledger(const Ledger& ledger, std::size_t pairs)
{
    const std::uint64_t removed =
        std::accumulate(ledger.removed.begin(), ledger.removed.end(), std::uint64_t{0});
    CHECK(ledger.pairs == pairs);
    CHECK(removed + ledger.exact + ledger.left == ledger.pairs);
}

void check_against_brute_force(const SceneModel& model, const SceneOptions& options)
{
    Scene scene = support::scene_of(model);
    const std::vector<Impact> want = model.impacts(options.pair);
    const Impacts got = scene.impacts(options);
    check_equal(got.found, want);
    CHECK(got.known_until == options.pair.t_max);
    CHECK(scene.ledger().left == 0);
    check_first(scene.first_impact(options), want, options.pair.t_max);
    std::vector<Impact> visited;
    scene.visit_impacts(
        [&](const Impact& impact) {
            visited.push_back(impact);
            return 1.0;
        },
        options);
    CHECK(visited.size() == want.size());
}

} // namespace

TEST_CASE("scene: every impact and the first are those of brute force over all pairs")
{
    std::size_t impacts = 0;
    for (const std::string_view name : support::scene_names) {
        for (const std::size_t n : {1U, 2U, 16U, 17U, 40U, 300U}) {
            CAPTURE(name);
            CAPTURE(n);
            const SceneModel model = draw_model(name, n, 5 + n);
            impacts += model.impacts().size();
            check_against_brute_force(model, {});
        }
    }
    CHECK(impacts > 1000);
}

TEST_CASE("scene: the same with every option of time_of_impact")
{
    Options some;
    some.t_max = 0.4;
    some.target_gap = 0.05;
    Options rough;
    rough.tolerance = 1e-3;
    rough.detail = Detail::time_only;
    Options leaving;
    leaving.start_contact = StartContact::ignore_if_separating;
    Options ignoring;
    ignoring.start_contact = StartContact::ignore;
    Options now;
    now.t_max = 0;
    for (const Options& options : {some, rough, leaving, ignoring, now}) {
        for (const std::string_view name : {"gas", "clustered", "bullets", "rain"}) {
            CAPTURE(name);
            check_against_brute_force(draw_model(name, 200, 21), {options});
        }
    }
}

TEST_CASE("scene: whichever layers are switched off, the answers are the same")
{
    for (const std::string_view name : support::scene_names) {
        SceneModel model = draw_model(name, 150, 31);
        for (BodyId i = 0; i < model.bodies.size(); ++i) {
            model.bodies[i].category = i % 3 == 0 ? 2 : 1;
            model.bodies[i].mask = i % 5 == 0 ? 1 : 3;
        }
        model.filter = [](BodyId a, BodyId b) { return (a + b) % 7 != 0; };
        for (int k = 0; k <= layer_count; ++k) {
            CAPTURE(name);
            CAPTURE(k);
            SceneOptions options;
            options.without = static_cast<Layer>(k);
            check_against_brute_force(model, options);
            options.without = options.without | Layer::simd | Layer::spheres | Layer::receding | Layer::late;
            check_against_brute_force(model, options);
        }
    }
}

TEST_CASE("scene: the ledger tells of every pair once")
{
    for (const std::string_view name : support::scene_names) {
        CAPTURE(name);
        const SceneModel model = draw_model(name, 500, 51);
        Scene scene = support::scene_of(model);
        std::size_t unbounded = 0;
        for (const Body& b : model.bodies)
            unbounded += std::holds_alternative<HalfSpace>(b.shape) || std::holds_alternative<Plane>(b.shape);
        const std::size_t pairs = 500 * 499 / 2 - unbounded * (unbounded > 0 ? unbounded - 1 : 0) / 2;
        scene.impacts();
        check_ledger(scene.ledger(), pairs);
        scene.first_impact();
        check_ledger(scene.ledger(), pairs);
        scene.overlapping();
        check_ledger(scene.ledger(), pairs);
        SceneOptions few;
        few.max_tests = 20;
        scene.impacts(few);
        check_ledger(scene.ledger(), pairs);
        CHECK(scene.ledger().exact <= 20);
    }
}

TEST_CASE("scene: what a budget leaves open is told, and the times are safe")
{
    std::size_t undecided = 0;
    for (const std::string_view name : {"bullets", "rain", "gas"}) {
        CAPTURE(name);
        const SceneModel model = draw_model(name, 400, 61);
        Scene scene = support::scene_of(model);
        const std::vector<Impact> want = model.impacts();
        REQUIRE(want.size() > 0);
        for (const std::size_t budget : {0U, 1U, 3U, 10U, 40U, 100'000U}) {
            SceneOptions options;
            options.max_tests = budget;
            const Impact first = scene.first_impact(options);
            CHECK(first.toi.t <= want.front().toi.t);
            CHECK(scene.ledger().exact <= budget);
            if (first.toi.status == Status::undecided && first.b == no_body)
                ++undecided;
            else
                CHECK(first.toi.t == want.front().toi.t); // of equal times it may be another pair's
            const Impacts some = scene.impacts(options);
            std::size_t known = 0;
            for (const Impact& impact : want)
                known += impact.toi.t < some.known_until;
            for (const Impact& impact : some.found)
                known -= impact.toi.t < some.known_until;
            CHECK(known == 0);
        }
    }
    CHECK(undecided > 3);
}

TEST_CASE("scene: a visitor may narrow the time and stop")
{
    const SceneModel model = draw_model("rain", 400, 71);
    Scene scene = support::scene_of(model);
    const std::vector<Impact> want = model.impacts();
    REQUIRE(want.size() > 20);
    int told = 0;
    scene.visit_impacts([&](const Impact&) {
        ++told;
        return told == 5 ? -1.0 : 1.0;
    });
    CHECK(told == 5);
    Impact earliest;
    earliest.toi.t = 2;
    scene.visit_impacts([&](const Impact& impact) {
        CHECK(impact.toi.t <= std::min(1.0, earliest.toi.t));
        if (impact.toi.t < earliest.toi.t) earliest = impact;
        return earliest.toi.t;
    });
    CHECK(earliest.toi.t == want.front().toi.t);
}

TEST_CASE("scene: a great many bodies at one point can be asked without asking all of their pairs")
{
    Scene scene;
    const std::size_t n = 20'000;
    for (std::size_t i = 0; i < n; ++i)
        scene.add({Sphere{0.5}});
    const Impact first = scene.first_impact();
    CHECK(first.a == 0);
    CHECK(first.b == 1);
    CHECK(first.toi.status == Status::touching);
    CHECK(scene.ledger().exact < 100'000);
    std::size_t told = 0;
    scene.visit_impacts([&](const Impact&) { return ++told < 1'000'000 ? 1.0 : -1.0; });
    CHECK(told == 1'000'000);
    SceneOptions few;
    few.max_tests = 1000;
    CHECK(scene.impacts(few).found.size() == 1000);
    CHECK(scene.impacts(few).known_until == 0);
}
