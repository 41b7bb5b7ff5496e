// SPDX-License-Identifier: BSD-3-Clause
#include "random.h"
#include "scene_brute.h"
#include "scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

using namespace brink;
using support::draw_model;
using support::Random;
using support::same;
using support::SceneModel;

namespace {

void check_equal(Scene& scene, const SceneModel& model)
{
    const std::vector<Impact> want = model.impacts();
    const Impacts got = scene.impacts();
    REQUIRE(got.found.size() == want.size());
    for (std::size_t i = 0; i < want.size(); ++i)
        CHECK(same(got.found[i], want[i]));
}

/// Overlaps, casts and rays, and that safe times come to an end.
void check_others(Scene& scene, const SceneModel& model, double scale)
{
    const std::vector<BodyPair> overlaps = model.overlapping();
    const std::span<const BodyPair> found = scene.overlapping().found;
    CHECK(std::equal(found.begin(), found.end(), overlaps.begin(), overlaps.end()));
    Motion motion = model.bodies.front().motion;
    motion.translation = scale * Vec3(4, 5, 6);
    const std::vector<Impact> cast = model.cast(Sphere{scale}, motion, {});
    const Impacts met = scene.cast_all(Sphere{scale}, motion);
    CHECK(std::equal(met.found.begin(), met.found.end(), cast.begin(), cast.end(),
                     [](const Impact& x, const Impact& y) { return same(x, y); }));
    const std::vector<RayImpact> rays = model.rays(motion.start.position, motion.translation, 2, {});
    const RayImpacts hit = scene.ray_cast_all(motion.start.position, motion.translation, 2);
    CHECK(std::equal(
        hit.found.begin(), hit.found.end(), rays.begin(), rays.end(),
        [](const RayImpact& x, const RayImpact& y) { return x.body == y.body && x.hit.t == y.hit.t; }));
    CHECK(cast.size() + rays.size() + overlaps.size() > 0);
    CHECK(scene.safe_times().size() == model.count());
}

/// One change to the scene and the same to the model.
void change(Random& random, Scene& scene, SceneModel& model)
{
    const auto id = static_cast<BodyId>(random.index(static_cast<int>(model.bodies.size())));
    Body body = model.bodies[id];
    const int what = random.index(6);
    if (model.gone[id] || what == 0) {
        body.motion.start.position += random.in_cube(0.3);
        model.bodies.push_back(body);
        model.gone.push_back(false);
        CHECK(scene.add(body) == model.bodies.size() - 1);
        return;
    }
    if (what == 1) {
        scene.remove(id);
        model.gone[id] = true;
        return;
    }
    if (what == 2 && !body.immovable) {
        scene.sleep(id);
        body.asleep = true;
        body.motion.translation = body.motion.rotation = {0, 0, 0};
    } else if (what == 3) {
        scene.wake(id);
        body.asleep = false;
    } else if (what == 4) {
        body.motion.start.position += random.in_cube(0.5);
        scene.set_motion(id, body.motion);
    } else {
        body.mask = static_cast<std::uint32_t>(1 + random.index(3));
        body.category = static_cast<std::uint32_t>(1 + random.index(3));
        scene.replace(id, body);
    }
    model.bodies[id] = body;
}

std::string message_of(const std::function<void()>& act)
{
    try {
        act();
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return {};
}

} // namespace

TEST_CASE("scene: after any changes it answers like one made anew")
{
    Random random(3);
    for (const std::string_view name : support::scene_names) {
        CAPTURE(name);
        SceneModel model = draw_model(name, 120, 7);
        Scene scene = support::scene_of(model);
        for (int step = 0; step < 25; ++step) {
            CAPTURE(step);
            for (int k = random.index(12); k >= 0; --k)
                change(random, scene, model);
            CHECK(scene.size() == model.count());
            check_equal(scene, model);
        }
    }
}

TEST_CASE("scene: bodies far away, tiny, huge or at one point are not lost")
{
    for (const double scale : {1e-300, 1e-30, 1e-9, 1e9, 1e30, 1e300}) {
        for (const double offset : {0.0, 1e3, 1e7}) {
            CAPTURE(scale);
            CAPTURE(offset);
            SceneModel model = draw_model("gas", 60, 13);
            for (Body& b : model.bodies) {
                b.motion.start.position = scale * (b.motion.start.position + Vec3(offset, 0, 0));
                b.motion.translation = scale * b.motion.translation;
                b.shape = Sphere{scale * 0.4};
            }
            model.bodies.push_back({Sphere{0}, {}});
            model.bodies.push_back({Box{{0, 0, 0}}, {}});
            model.bodies.push_back({Sphere{1e300}, {}});
            model.gone.resize(model.bodies.size(), false);
            Scene scene = support::scene_of(model);
            check_equal(scene, model);
            const std::vector<Impact> want = model.impacts();
            REQUIRE(!want.empty());
            CHECK(same(scene.first_impact(), want.front()));
            check_others(scene, model, scale);
        }
    }
}

TEST_CASE("scene: bodies leave before they are first looked at, in any order")
{
    Scene many;
    constexpr BodyId n = 400'000;
    for (BodyId id = 0; id < n; ++id)
        many.add({.shape = Sphere{1}, .asleep = id % 2 == 0});
    for (BodyId id = 0; id < n; ++id)
        many.remove(id);
    CHECK(many.size() == 0);

    SceneModel model = draw_model("asleep", 300, 23);
    Scene scene = support::scene_of(model);
    Random random(24);
    for (int k = 0; k < 200; ++k) {
        const auto id = static_cast<BodyId>(random.index(300));
        if (!model.gone[id]) scene.remove(id);
        model.gone[id] = true;
    }
    CHECK(scene.size() == model.count());
    check_equal(scene, model);
    CHECK(!model.impacts().empty());
}

TEST_CASE("scene: what is invalid is refused by name, and nothing changes")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    SceneModel model = draw_model("gas", 30, 3);
    Scene scene = support::scene_of(model);
    scene.remove(4);
    model.gone[4] = true;
    Motion bad;
    bad.translation.y() = nan;
    const auto names = [](const std::string& text, std::initializer_list<const char*> parts) {
        for (const char* part : parts) {
            CAPTURE(text);
            CHECK(text.find(part) != std::string::npos);
        }
    };
    names(message_of([&] { scene.add({Sphere{-2}}); }), {"body 30", "shape.radius", "-2"});
    names(message_of([&] { scene.set_motion(7, bad); }), {"body 7", "motion.translation", "nan"});
    names(message_of([&] { scene.set_motion(4, {}); }), {"no body 4", "removed"});
    names(message_of([&] { scene.remove(99); }), {"no body 99"});
    names(message_of([&] { scene.replace(2, {Sphere{1}, {}, 0}); }), {"body 2", "category", "0"});
    const std::vector<BodyId> ids{1, 2, 3};
    const std::vector<Motion> motions{{}, {}, bad};
    names(message_of([&] { scene.set_motions(ids, motions); }), {"body 3", "motion.translation"});
    names(message_of([&] { scene.set_motions(ids, std::span(motions).first(2)); }),
          {"3 bodies", "2 motions"});
    Body still{Sphere{1}, {}};
    still.immovable = true;
    still.motion.translation = {0, 0, 1};
    names(message_of([&] { scene.add(still); }), {"body 30", "motion.translation", "immovable"});
    SceneOptions late;
    late.pair.t_max = 2;
    names(message_of([&] { scene.impacts(late); }), {"options.pair.t_max", "2"});
    CHECK(scene.size() == 29);
    CHECK(!scene.contains(4));
    check_equal(scene, model);
}

TEST_CASE("scene: a visitor that changes or asks the scene is told that it must not")
{
    Scene scene;
    scene.add({Sphere{1}});
    scene.add({Sphere{1}});
    const auto with = [&](const std::function<void()>& act) {
        scene.visit_impacts([&](const Impact&) {
            act();
            return 1.0;
        });
    };
    CHECK_THROWS_AS(with([&] { scene.remove(0); }), std::logic_error);
    CHECK_THROWS_AS(with([&] { scene.impacts(); }), std::logic_error);
    CHECK_THROWS_AS(with([&] { scene.set_motion(1, {}); }), std::logic_error);
    CHECK(scene.size() == 2);
    CHECK(scene.impacts().found.size() == 1);
}

TEST_CASE("scene: bodies at one place whose masks exclude each other are passed over together")
{
    constexpr std::size_t n = 30'000;
    for (const bool rest : {false, true}) {
        Scene scene;
        for (std::size_t i = 0; i < n; ++i)
            scene.add({.shape = Sphere{1}, .category = 2, .mask = 1, .asleep = rest && i % 2 == 0});
        CHECK(scene.impacts().found.empty());
        CHECK(scene.ledger().by(Layer::mask) < 20 * n); // not of n^2 / 2
        CHECK(scene.overlapping().found.empty());
        CHECK(scene.ledger().by(Layer::mask) < 20 * n);
        CHECK(scene.cast_all(Sphere{1}, {}).complete);
        CHECK(scene.safe_times().size() == n);
        scene.add({.shape = Sphere{1}}); // in group 1, which they all meet
        CHECK(scene.impacts().found.size() == n);
    }
}

TEST_CASE("scene: groups that live apart or mixed are answered as brute force answers")
{
    Random random(41);
    std::size_t impacts = 0;
    for (const std::string_view name : support::scene_names) {
        for (const bool mixed : {false, true}) {
            CAPTURE(name);
            CAPTURE(mixed);
            SceneModel model = draw_model(name, 400, 43);
            for (Body& b : model.bodies) {
                const auto part = static_cast<unsigned>(mixed                             ? random.index(4)
                                                        : b.motion.start.position.x() > 5 ? 2
                                                                                          : 0);
                b.category = 1U << part;
                b.mask = part == 0 ? 0xffffffff : part == 2 ? 0xbU : 0x5U;
            }
            Scene scene = support::scene_of(model);
            check_equal(scene, model);
            for (int k = 0; k < 40; ++k)
                change(random, scene, model);
            check_equal(scene, model);
            impacts += model.impacts().size();
        }
    }
    CHECK(impacts > 500);
}
