// SPDX-License-Identifier: BSD-3-Clause
#include "random.h"
#include "scene_brute.h"
#include "scenes.h"

#include <brink/overlap.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace brink;
using support::draw_model;
using support::Random;
using support::same;
using support::SceneModel;

namespace {

bool same(const RayImpact& x, const RayImpact& y)
{
    return x.body == y.body && x.hit.status == y.hit.status && x.hit.t == y.hit.t &&
           x.hit.point == y.hit.point && x.hit.normal == y.hit.normal;
}

/// Somewhere among the bodies.
Vec3 place(Random& random, const SceneModel& model)
{
    const auto i = static_cast<std::size_t>(random.index(static_cast<int>(model.bodies.size())));
    const Vec3 off = random.in_cube(2);
    return model.bodies[i].motion.start.position + off;
}

Shape draw_cast(Random& random)
{
    const double size = random.between(0.01, 1);
    switch (random.index(5)) {
    case 0:
        return Sphere{size};
    case 1:
        return Box{{size, 0.3, 0.1}};
    case 2:
        return Capsule{{0, 0, -size}, {0, 0.1, size}, 0.2};
    case 3:
        return Cone{size, 0.4};
    default:
        return HalfSpace{{0, 0, 1}, -3};
    }
}

} // namespace

TEST_CASE("scene: a shape that is cast meets what brute force meets")
{
    Random random(71);
    std::size_t hits = 0;
    for (const std::string_view name : support::scene_names) {
        SceneModel model = draw_model(name, 200, 81);
        model.bodies[3].category = 4;
        Scene scene = support::scene_of(model);
        for (int k = 0; k < 40; ++k) {
            CAPTURE(name);
            CAPTURE(k);
            const Shape shape = draw_cast(random);
            Motion motion;
            motion.start.position = place(random, model);
            motion.start.orientation = random.rotation();
            motion.translation = random.in_cube(6);
            motion.rotation = random.in_cube(1);
            SceneOptions options;
            options.mask = k % 4 == 0 ? 3 : 0xffffffff;
            options.pair.t_max = k % 3 == 0 ? 0.5 : 1;
            const std::vector<Impact> want = model.cast(shape, motion, options);
            const Impact first = scene.cast(shape, motion, options);
            if (want.empty()) {
                CHECK(first.toi.status == Status::separated);
                CHECK(first.toi.t == options.pair.t_max);
            } else {
                CHECK(same(first, want.front()));
            }
            const Impacts all = scene.cast_all(shape, motion, options);
            REQUIRE(all.found.size() == want.size());
            for (std::size_t i = 0; i < want.size(); ++i)
                CHECK(same(all.found[i], want[i]));
            hits += want.size();
        }
    }
    CHECK(hits > 500);
}

TEST_CASE("scene: a ray meets what brute force meets")
{
    Random random(72);
    std::size_t hits = 0;
    for (const std::string_view name : support::scene_names) {
        const SceneModel model = draw_model(name, 300, 91);
        Scene scene = support::scene_of(model);
        for (int k = 0; k < 100; ++k) {
            CAPTURE(name);
            CAPTURE(k);
            const Vec3 origin = place(random, model);
            const Vec3 direction = k % 10 == 0 ? Vec3{0, 0, 0} : random.in_cube(3);
            const double t_max = k % 3 == 0 ? infinity : random.between(0, 4);
            const std::vector<RayImpact> want = model.rays(origin, direction, t_max);
            const RayImpact first = scene.ray_cast(origin, direction, t_max);
            if (want.empty()) {
                CHECK(first.hit.status == Status::separated);
                CHECK(first.hit.t == t_max);
            } else {
                CHECK(same(first, want.front()));
            }
            const std::span<const RayImpact> all = scene.ray_cast_all(origin, direction, t_max).found;
            REQUIRE(all.size() == want.size());
            for (std::size_t i = 0; i < want.size(); ++i)
                CHECK(same(all[i], want[i]));
            hits += want.size();
        }
    }
    CHECK(hits > 300);
}

TEST_CASE("scene: the pairs that overlap at the start are those of brute force")
{
    std::size_t pairs = 0;
    for (const std::string_view name : support::scene_names) {
        CAPTURE(name);
        const SceneModel model = draw_model(name, 400, 93);
        Scene scene = support::scene_of(model);
        const std::vector<BodyPair> want = model.overlapping();
        const std::span<const BodyPair> got = scene.overlapping().found;
        REQUIRE(got.size() == want.size());
        CHECK(std::equal(got.begin(), got.end(), want.begin()));
        pairs += want.size();
    }
    CHECK(pairs > 200);
}

TEST_CASE("scene: candidates are the pairs whose swept bounds overlap")
{
    for (const std::string_view name : support::scene_names) {
        CAPTURE(name);
        const SceneModel model = draw_model(name, 300, 94);
        Scene scene = support::scene_of(model);
        std::vector<Aabb> bounds;
        for (BodyId id = 0; id < model.bodies.size(); ++id)
            bounds.push_back(scene.swept_bounds(id));
        std::vector<BodyPair> want;
        for (BodyId a = 0; a < bounds.size(); ++a)
            for (BodyId b = a + 1; b < bounds.size(); ++b)
                if (model.asked(a, b) && (bounds[a].min.array() <= bounds[b].max.array()).all() &&
                    (bounds[b].min.array() <= bounds[a].max.array()).all())
                    want.push_back({a, b});
        const std::span<const BodyPair> got = scene.candidates();
        std::vector<BodyPair> found(got.begin(), got.end());
        std::sort(found.begin(), found.end(),
                  [](BodyPair x, BodyPair y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
        // Against the ground bounds are told by the balls: fewer pairs than its bounds, which are all of
        // space.
        if (name == "stacks" || name == "rain")
            CHECK(std::includes(want.begin(), want.end(), found.begin(), found.end(),
                                [](BodyPair x, BodyPair y) { return x.a != y.a ? x.a < y.a : x.b < y.b; }));
        else
            CHECK(found == want);
    }
}
