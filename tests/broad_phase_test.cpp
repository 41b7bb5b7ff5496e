// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase.h"

#include "support/draw.h"
#include "support/moving.h"
#include "support/random.h"
#include "support/scenes.h"
#include "sweep.h"

#include <doctest/doctest.h>

#include <cstring>
#include <string_view>

using namespace brink;
using support::Random;

namespace {

bool same(const Box3f& a, const Box3f& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// A store and its broad phase, changed as a scene changes them.
struct World {
    BodyStore store;
    BroadPhase broad;

    void add(const Body& body) { broad.add(store.add(body), store); }
    void remove(std::uint32_t slot)
    {
        broad.remove(slot);
        store.remove(slot);
    }
    void replace(std::uint32_t slot, const Body& body)
    {
        broad.remove(slot);
        store.replace(slot, body);
        broad.add(slot, store);
    }
    void move(std::uint32_t slot, const Motion& motion)
    {
        store.bodies[slot].motion = motion;
        broad.moved(slot, store);
        broad.refit_later();
    }
};

struct Wrong {
    int box = 0, ball = 0, home = 0, place = 0, bound = 0;
    friend bool operator==(const Wrong&, const Wrong&) = default;
};

/// The bodies of one tree: seen[slot] counts where each was found.
void look(const World& w, const BlockTree& tree, bool at_rest_only, std::vector<int>& seen, Wrong& wrong)
{
    std::size_t held = 0;
    for (std::size_t place = 0; place < tree.slots.size(); ++place) {
        const std::uint32_t slot = tree.slots[place];
        const std::size_t leaf = place / lanes, lane = place % lanes;
        const Box3f box = box_at(tree.levels[0][leaf], static_cast<int>(lane));
        if (slot == no_slot) {
            wrong.place += !(std::isnan(box.min[0]) && std::isnan(box.max[2]));
            continue;
        }
        ++held;
        ++seen[slot];
        const Body& body = w.store.bodies[slot];
        const Sweep s = sweep(body, w.broad.origin);
        wrong.home += at_rest(body) != at_rest_only;
        wrong.box += !same(box, s.box) || !same(w.broad.box(slot), s.box);
        for (int axis = 0; axis < 3; ++axis)
            wrong.ball += tree.balls[leaf].from[axis][lane] != s.from[axis] ||
                          tree.balls[leaf].by[axis][lane] != s.by[axis];
        wrong.ball += tree.balls[leaf].radius[lane] != s.radius;
        std::size_t at = leaf;
        for (std::size_t l = 1; l < static_cast<std::size_t>(tree.height); ++l, at /= lanes) {
            const Box3f above = box_at(tree.levels[l][at / lanes], static_cast<int>(at % lanes));
            for (int axis = 0; axis < 3; ++axis)
                wrong.bound += !(above.min[axis] <= box.min[axis] && above.max[axis] >= box.max[axis]);
            wrong.bound += tree.least[l][at / lanes] > w.store.ids[slot];
        }
        wrong.bound += tree.least[0][leaf] > w.store.ids[slot];
    }
    wrong.place += held != tree.count;
}

Wrong wrong_in(const World& w)
{
    Wrong wrong;
    std::vector<int> seen(w.store.bodies.size());
    look(w, w.broad.movers, false, seen, wrong);
    look(w, w.broad.resting, true, seen, wrong);
    look(w, w.broad.arrived, true, seen, wrong);
    for (const std::uint32_t slot : w.broad.unbounded) {
        ++seen[slot];
        const std::size_t kind = w.store.bodies[slot].shape.index();
        wrong.home += !w.broad.is_unbounded(slot) || (kind != 4 && kind != 5);
    }
    for (std::size_t slot = 0; slot < seen.size(); ++slot)
        wrong.place += seen[slot] != (w.store.ids[slot] == no_body ? 0 : 1);
    return wrong;
}

Body draw_body(Random& random, double far)
{
    const int kind = random.index(10);
    Body body{support::draw_shape(random, static_cast<std::size_t>(kind), support::ShapeStyle::any)};
    body.motion.start.position = far * random.in_cube(1);
    body.motion.start.orientation = support::draw_orientation(random);
    const int rest = random.index(4);
    body.asleep = rest == 0;
    body.immovable = rest == 1;
    if (!at_rest(body)) {
        body.motion.translation = random.in_cube(3);
        body.motion.rotation = random.in_cube(2);
    }
    return body;
}

std::uint32_t any_slot(Random& random, const World& w)
{
    for (;;) {
        const auto slot = static_cast<std::uint32_t>(random.index(static_cast<int>(w.store.bodies.size())));
        if (w.store.ids[slot] != no_body) return slot;
    }
}

/// A body is added, removed, replaced, moved, put to sleep or woken.
void change(World& w, Random& random, double far, std::size_t most)
{
    const int what = random.index(10);
    const Body body = draw_body(random, far);
    if (w.store.count() < 2 || (what < 2 && w.store.count() < most)) return w.add(body);
    const std::uint32_t slot = any_slot(random, w);
    Body changed = w.store.bodies[slot];
    if (what < 4) return w.remove(slot);
    if (what == 4) return w.replace(slot, body);
    if (what < 8) {
        changed.motion.start.position += random.in_cube(what == 7 ? far : 1);
        return w.move(slot, changed.motion);
    }
    changed.asleep = what == 8;
    if (what == 8) changed.motion.translation = changed.motion.rotation = Vec3(0, 0, 0);
    w.replace(slot, changed);
}

} // namespace

TEST_CASE("BroadPhase: after any changes each body is in one place with the bounds of its sweep")
{
    std::size_t resting = 0, arrived = 0, movers = 0, unbounded = 0;
    int origins = 0;
    for (int i = 0; i < 12; ++i) {
        Random random(20261122, static_cast<std::uint64_t>(i));
        World w;
        const double far = i % 3 == 0 ? 1e6 : 30;
        const std::size_t most = i % 2 == 0 ? 40 : 1500;
        for (std::size_t k = 0; k < most; ++k) {
            const Body body = draw_body(random, far);
            w.add(body);
        }
        for (int step = 0; step < 40; ++step) {
            const V3 before = w.broad.origin;
            w.broad.update(w.store);
            origins += !(before == w.broad.origin);
            CAPTURE(i);
            CAPTURE(step);
            CHECK(wrong_in(w) == Wrong{});
            resting += w.broad.resting.count;
            arrived += w.broad.arrived.count;
            movers += w.broad.movers.count;
            unbounded += w.broad.unbounded.size();
            const int changes = step % 5 == 4 ? 400 : random.index(10);
            for (int k = 0; k < changes; ++k)
                change(w, random, far, most);
        }
    }
    CHECK(resting > 10'000);
    CHECK(arrived > 1'000);
    CHECK(movers > 10'000);
    CHECK(unbounded > 1'000);
    CHECK(origins == 0); // they lie about it
}

TEST_CASE("BroadPhase: leaves that come apart are sorted again, those that keep together are not")
{
    World w;
    Random random(9);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 at = random.in_cube(20);
        w.add({Sphere{0.1}, support::resting(at)});
    }
    w.broad.update(w.store);
    const std::vector<std::uint32_t> order = w.broad.movers.slots;
    const double together = w.broad.movers.spread();
    for (std::uint32_t slot = 0; slot < 2000; ++slot)
        w.move(slot, support::moving(w.store.bodies[slot].motion.start.position, {0.2, 0, 0}));
    w.broad.update(w.store);
    CHECK(w.broad.movers.slots == order);
    for (std::uint32_t slot = 0; slot < 2000; ++slot) {
        const Vec3 at = random.in_cube(20);
        w.move(slot, support::resting(at));
    }
    w.broad.update(w.store);
    CHECK(w.broad.movers.slots != order);
    CHECK(w.broad.movers.spread() < 1.5 * together);
    CHECK(wrong_in(w) == Wrong{});
}

TEST_CASE("BroadPhase: the origin follows the bodies, and all bounds with it")
{
    World w;
    Random random(10);
    for (int i = 0; i < 30; ++i)
        w.add(draw_body(random, 1));
    w.broad.update(w.store);
    CHECK(w.broad.origin == V3{});
    for (int i = 0; i < 3000; ++i) {
        Body body = draw_body(random, 1);
        body.motion.start.position += Vec3(1e7, 0, 0);
        body.asleep = body.immovable = false; // what rests already is not built anew for them
        w.add(body);
    }
    w.broad.update(w.store);
    CHECK(w.broad.origin.x == doctest::Approx(1e7));
    CHECK(wrong_in(w) == Wrong{});
}

TEST_CASE("BroadPhase: at most 80 bytes for each of many bodies")
{
    for (const std::string_view name : {"gas", "asleep", "bullets"}) {
        for (const std::size_t first : {20'000U, 12'000U}) { // at once, or many and then more
            Scene scene;
            for (const Body& body : support::draw_scene(name, 20'000, 1).bodies) {
                scene.add(body);
                if (scene.size() == first) scene.update();
            }
            scene.update();
            CAPTURE(name);
            CAPTURE(first);
            const std::size_t bytes = scene.broad_phase_bytes();
            CHECK(bytes <= 80 * scene.size());
            scene.update();
            CHECK(scene.broad_phase_bytes() == bytes);
        }
    }
}
