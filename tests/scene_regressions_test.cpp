// SPDX-License-Identifier: BSD-3-Clause
// Scenes that were once answered wrongly.
#include "moving.h"
#include "scene_brute.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <stdexcept>

using namespace brink;
using support::moving;

namespace {

Body at(const Shape& shape, const Vec3& position, const Vec3& translation = {0, 0, 0})
{
    return {shape, moving(position, translation)};
}

constexpr Layers no_balls = Layers(Layer::receding) | Layer::spheres | Layer::late;

bool adds_up(const Ledger& l)
{
    const std::uint64_t sum = std::accumulate(l.removed.begin(), l.removed.end(), l.exact + l.left);
    return sum == l.pairs && l.left <= l.pairs;
}

} // namespace

TEST_CASE("scene: a plane whose own place is far along it")
{
    const double c = std::cos(0.15), s = std::sin(0.15);
    for (const double far : {1e10, 1e11, 1e12}) {
        Body plane = at(Plane{{c, s, 0}, 0}, {-s * far, c * far, 0});
        plane.immovable = true;
        const Vec3 near = Vec3{c, s, 0} * (-1e-3 * 1.00001);
        const support::SceneModel model{{plane, at(Sphere{1e-3}, near)}, {}, {}};
        Scene scene = support::scene_of(model);
        CHECK(scene.impacts().found.size() == model.impacts().size());
    }
}

TEST_CASE("scene: without balls no candidate has the time of an earlier query")
{
    Scene scene;
    for (const double x : {10, 5, 30, 35, 40})
        scene.add(at(Sphere{1}, {x, 0, 0}));
    scene.cast(Sphere{1}, moving({100, 0, 0}, {-100, 0, 0}));
    SceneOptions options;
    options.without = no_balls;
    const Motion there = moving({0, 0, 0}, {100, 0, 0});
    CHECK(scene.cast(Sphere{1}, there, options).b == 1);
    CHECK(scene.ray_cast({0, 0, 0}, {100, 0, 0}, 1, options).body == 1);
    options.max_tests = 0;
    CHECK(scene.cast_all(Sphere{1}, there, options).known_until <= 0.03);
    CHECK(!scene.cast_all(Sphere{1}, there, options).complete);
}

TEST_CASE("scene: rays of any length")
{
    Scene scene;
    scene.add(at(Sphere{1}, {5, 0, 0}));
    for (const double length : {1e-300, 1e-200, 1e-100, 1e100, 1e200, 1e300}) {
        CAPTURE(length);
        const RayImpact met = scene.ray_cast({0, 0, 0}, {length, 0, 0}, infinity);
        CHECK(met.body == 0);
        CHECK(met.hit.t == doctest::Approx(4 / length));
    }
}

TEST_CASE("scene: overlaps are asked by id, whoever moves")
{
    const Body a =
        at(Box{{1.4000000000000001, 1, 1.7000000000000002}}, {2.5, 2.3000000000000003, 1.9000000000000001});
    const Body b = at(Box{{2.5, 1.9000000000000001, 3.6000000000000001}},
                      {6.4000000000000004, 0.80000000000000004, 0.80000000000000004});
    for (int rests = 0; rests < 3; ++rests) {
        for (int turned = 0; turned < 2; ++turned) {
            support::SceneModel model{{turned == 1 ? b : a, turned == 1 ? a : b}, {}, {}};
            if (rests < 2) model.bodies[static_cast<std::size_t>(rests)].asleep = true;
            Scene scene = support::scene_of(model);
            CHECK(scene.overlapping().found.size() == model.overlapping().size());
        }
    }
}

TEST_CASE("scene: masks hold for casts and rays, whatever is switched off")
{
    Scene scene;
    Body other = at(Sphere{1}, {5, 0, 0});
    other.category = 2;
    scene.add(other);
    SceneOptions options;
    options.mask = 1;
    for (const Layers without : {Layers{}, Layers(Layer::mask)}) {
        options.without = without;
        CHECK(scene.cast_all(Sphere{1}, moving({0, 0, 0}, {10, 0, 0}), options).found.empty());
        CHECK(scene.cast_all(Plane{{1, 0, 0}, 0}, moving({0, 0, 0}, {10, 0, 0}), options).found.empty());
        CHECK(scene.ray_cast_all({0, 0, 0}, {10, 0, 0}, 1, options).found.empty());
    }
}

TEST_CASE("scene: nothing asked is not nothing there")
{
    Scene scene;
    scene.add(at(Sphere{1}, {0, 0, 0}));
    scene.add(at(Sphere{1}, {1, 0, 0}));
    SceneOptions options;
    options.max_tests = 0;
    for (const double t_max : {0.0, 1.0}) {
        options.pair.t_max = t_max;
        CHECK(scene.first_impact(options).toi.status == Status::undecided);
        CHECK(scene.first_impact(options).toi.t == 0);
        CHECK(scene.cast(Sphere{1}, {}, options).toi.status == Status::undecided);
        CHECK(!scene.impacts(options).complete);
    }
    options.max_tests = 1;
    CHECK(scene.impacts(options).complete);
    CHECK(scene.first_impact(options).toi.status == Status::touching);
}

TEST_CASE("scene: ledgers add up for casts, rays and resting pairs that are searched all the same")
{
    Scene scene;
    for (int i = 0; i < 5; ++i) {
        Body still = at(Sphere{1}, {1.5 * i, 1.5 * i, 0});
        still.immovable = true;
        scene.add(still);
    }
    SceneOptions options;
    for (const Layers without : {Layers(Layer::asleep), Layers(Layer::immovable), Layers(Layer::mask)}) {
        options.without = without;
        scene.impacts(options);
        CHECK(adds_up(scene.ledger()));
    }
    scene.add(at(Plane{{1, 0, 0}, 0}, {0, 0, 0}));
    scene.ray_cast({-1, 0, 0}, {10, 0, 0});
    CHECK(adds_up(scene.ledger()));
    scene.cast(Plane{{1, 0, 0}, -20}, moving({0, 0, 0}, {30, 0, 0}));
    CHECK(adds_up(scene.ledger()));
    CHECK(scene.ledger().exact == 5);
}

TEST_CASE("scene: bounds hold the body far from the origin too")
{
    Scene scene;
    for (int i = 0; i < 50; ++i)
        scene.add(at(Sphere{0}, {1e15 + i, 0, 0}));
    scene.add(at(Sphere{0.06}, {1e15, 0, 0}));
    const Aabb box = scene.swept_bounds(50);
    CHECK(box.min.x() < 1e15);
    CHECK(box.max.x() > 1e15);
}

TEST_CASE("scene: no body is named twice, no visitor is empty")
{
    Scene scene;
    const BodyId id = scene.add(at(Sphere{1}, {0, 0, 0}));
    const BodyId twice[] = {id, id};
    const Motion motions[] = {moving({1, 0, 0}, {0, 0, 0}), {}};
    CHECK_THROWS_AS(scene.set_motions(twice, motions), std::invalid_argument);
    CHECK(scene.body(id).motion.start.position.x() == 0);
    CHECK_THROWS_AS(scene.visit_impacts({}), std::invalid_argument);
    scene.set_motions(std::span(twice).first(1), std::span(motions).first(1));
    CHECK(scene.body(id).motion.start.position.x() == 1);
}

TEST_CASE("scene: a floor away from the origin is met whatever layers are off")
{
    Scene scene;
    Body floor = at(HalfSpace{{0, 0, 1}, -5}, {0, 0, 0});
    floor.immovable = true;
    scene.add(floor);
    scene.add({.shape = Sphere{1}, .motion = moving({0, 0, 0}, {0, 0, -10})});
    scene.add({.shape = Sphere{1}, .motion = moving({50, 0, 0}, {0, 0, 10})});
    SceneOptions options;
    options.without = Layers(Layer::receding) | Layer::spheres | Layer::late;
    CHECK(scene.impacts(options).found.size() == 1);
    CHECK(scene.candidates(Bounds::boxes).size() == 1);
    CHECK(scene.candidates(Bounds::balls).size() == 1);
}

TEST_CASE("scene: a body or a point of the scene's own may be given back to it")
{
    Scene scene;
    Body first = at(Sphere{2}, {5, 0, 0});
    first.category = 4;
    scene.add(first);
    for (BodyId id = 1; id <= 100; ++id) {
        CHECK(scene.add(scene.body(id % 2 == 0 ? 0 : id - 1)) == id);
        CHECK(std::get<Sphere>(scene.body(id).shape).radius == 2);
        CHECK(scene.body(id).motion.start.position == Vec3(5, 0, 0));
        CHECK(scene.body(id).category == 4);
    }
    scene.remove(7);
    scene.add(scene.body(8)); // into the place of the seventh
    scene.replace(3, scene.body(4));
    scene.replace(3, scene.body(3));
    scene.set_motion(3, scene.body(3).motion);
    CHECK(scene.body(3).motion.start.position == Vec3(5, 0, 0));
    CHECK(scene.impacts().found.size() == 101 * 100 / 2);

    Scene two;
    two.add(at(Sphere{1}, {5, 0, 0}));
    two.add(at(Sphere{1}, {5, 5, 0}));
    const RayImpacts met = two.ray_cast_all({0, 0, 0}, {1, 0, 0}, 9);
    REQUIRE(met.found.size() == 1);
    const Vec3 from = met.found[0].hit.point;
    const RayImpacts next = two.ray_cast_all(met.found[0].hit.point, {1, 5, 0}, 9); // a point that is cleared
    REQUIRE(next.found.size() == 2);
    const RayHit alone = ray_cast(from, {1, 5, 0}, Sphere{1}, two.body(1).motion.start, 9);
    CHECK(next.found[1].hit.t == alone.t);
}

TEST_CASE("scene: a ray without end, a body beyond all bounds and a budget")
{
    Scene scene;
    for (const double x : {20.0, 10.0, 1e300})
        scene.add(at(Sphere{1}, {x, 0, 0}));
    SceneOptions options;
    for (const double t_max : {1e3, infinity})
        for (const std::size_t budget : {0U, 1U, 2U}) {
            CAPTURE(t_max);
            CAPTURE(budget);
            options.max_tests = budget;
            const RayImpact met = scene.ray_cast({0, 0, 0}, {1, 0, 0}, t_max, options);
            CHECK(met.hit.t <= 9);
            CHECK((met.body == 1 || met.hit.status == Status::undecided));
            const RayImpacts all = scene.ray_cast_all({0, 0, 0}, {1, 0, 0}, t_max, options);
            CHECK(!all.complete);
            CHECK(all.known_until <= (budget == 0 ? 9 : t_max));
            for (const double x : {9.0, 19.0})
                CHECK(
                    (all.known_until <= x || std::any_of(all.found.begin(), all.found.end(),
                                                         [&](const RayImpact& r) { return r.hit.t == x; })));
        }
    options.max_tests = 3;
    CHECK(scene.ray_cast({0, 0, 0}, {1, 0, 0}, infinity, options).body == 1);
    CHECK(scene.ray_cast_all({0, 0, 0}, {1, 0, 0}, infinity, options).complete);
}

TEST_CASE("scene: a query that is refused within another leaves that one's results alone")
{
    Scene scene;
    const int n = 600;
    for (int i = 0; i < n; ++i)
        scene.add(at(Sphere{1}, {0.001 * i, 0, 0}));
    const std::vector<std::function<void()>> acts{[&] { scene.cast(Sphere{1}, {}); },
                                                  [&] { scene.cast_all(Sphere{1}, {}); },
                                                  [&] { scene.overlapping(); },
                                                  [&] {
                                                      scene.ray_cast({0, 0, 0}, {1, 0, 0});
                                                  },
                                                  [&] {
                                                      scene.ray_cast_all({0, 0, 0}, {1, 0, 0});
                                                  },
                                                  [&] { scene.candidates(); },
                                                  [&] { scene.impacts(); },
                                                  [&] { scene.safe_times(); }};
    for (const auto& act : acts) {
        std::atomic<int> refused = 0;
        scene.set_filter([&](BodyId a, BodyId b) {
            if (a != 300 || b != 400) return true;
            try {
                act();
            } catch (const std::logic_error&) {
                ++refused;
            }
            return true;
        });
        const std::size_t pairs = n * (n - 1) / 2;
        CHECK(scene.impacts().found.size() == pairs);
        CHECK(scene.overlapping().found.size() == pairs);
        const std::span<const BodyPair> candidates = scene.candidates();
        CHECK(candidates.size() == pairs);
        CHECK(std::none_of(candidates.begin(), candidates.end(), [](BodyPair p) { return p.a == no_body; }));
        CHECK(refused >= 3);
    }
}
