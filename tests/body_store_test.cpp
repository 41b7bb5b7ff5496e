// SPDX-License-Identifier: BSD-3-Clause
#include "body_store.h"

#include "block.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

using namespace brink;
using support::Random;

namespace {

Body draw_body(Random& random)
{
    Body body{Sphere{random.between(0, 1)}};
    if (random.chance(0.3)) body.mask = 5;
    body.immovable = random.chance(0.3);
    body.asleep = random.chance(0.3);
    return body;
}

/// What the store counts, counted.
struct Count {
    std::size_t all = 0, picky = 0, immovable = 0, asleep = 0;
    friend bool operator==(const Count&, const Count&) = default;
};

Count counted(const BodyStore& store)
{
    Count c;
    for (std::size_t slot = 0; slot < store.bodies.size(); ++slot) {
        if (store.ids[slot] == no_body) continue;
        const Body& b = store.bodies[slot];
        ++c.all;
        c.picky += b.mask != 0xffffffff;
        c.immovable += b.immovable;
        c.asleep += b.asleep && !b.immovable;
    }
    return c;
}

std::string message(const BodyStore& store, BodyId id)
{
    try {
        static_cast<void>(store.slot(id));
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "";
}

} // namespace

TEST_CASE("BodyStore: ids in order and never again, slots again, counts that hold")
{
    Random random(31);
    BodyStore store;
    std::vector<BodyId> living;
    std::vector<double> radius; // by id
    std::size_t most = 0;
    for (int i = 0; i < 20'000; ++i) {
        const int what = random.index(5);
        const Body body = draw_body(random);
        const int any = random.index(static_cast<int>(std::max<std::size_t>(living.size(), 1)));
        const auto which = static_cast<std::size_t>(any);
        if (living.empty() || what < (living.size() < 200 ? 3 : 1)) {
            const std::uint32_t slot = store.add(body);
            CHECK(store.ids[slot] == radius.size());
            living.push_back(store.ids[slot]);
            radius.push_back(std::get<Sphere>(body.shape).radius);
        } else if (what == 3) {
            store.replace(store.slot(living[which]), body);
            radius[living[which]] = std::get<Sphere>(body.shape).radius;
        } else {
            const BodyId id = living[which];
            store.remove(store.slot(id));
            living[which] = living.back();
            living.pop_back();
            CHECK(!store.contains(id));
        }
        most = std::max(most, living.size());
        if (i % 100 != 0) continue;
        const Count c = counted(store);
        CHECK(c == Count{store.count(), store.picky, store.immovable, store.asleep});
        CHECK(c.all == living.size());
        for (const BodyId id : living) {
            CHECK(store.ids[store.slot(id)] == id);
            CHECK(std::get<Sphere>(store.bodies[store.slot(id)].shape).radius == radius[id]);
        }
    }
    CHECK(store.slots.size() > 5'000);
    CHECK(store.bodies.size() == most);
}

TEST_CASE("BodyStore: no table of ids is kept until a slot is used again, and then it is told of")
{
    BodyStore store;
    for (int i = 0; i < 100; ++i)
        store.add({Sphere{1}});
    store.remove(store.slot(40));
    CHECK(store.slots.empty());
    CHECK(store.next_id() == 100);
    CHECK(!store.contains(40));
    CHECK(store.add({Sphere{2}}) == 40);
    CHECK(store.slots.size() == 101);
    CHECK(store.slot(100) == 40);
    CHECK(store.slot(99) == 99);
    CHECK(!store.contains(40));

    Scene scene;
    scene.add({Sphere{1}});
    scene.update();
    const std::size_t before = scene.broad_phase_bytes();
    for (int i = 0; i < 10'000; ++i)
        scene.remove(scene.add({Sphere{1}}));
    CHECK(scene.broad_phase_bytes() >= before + 40'000);
}

TEST_CASE("BodyStore: who is not there is named")
{
    BodyStore store;
    store.add({Sphere{1}});
    store.remove(store.slot(store.ids[store.add({Sphere{1}})]));
    CHECK(message(store, 0).empty());
    CHECK(message(store, 1) == "brink::Scene: there is no body 1: it was removed");
    CHECK(message(store, 7) == "brink::Scene: there is no body 7");
    CHECK(message(store, no_body) == "brink::Scene: there is no body 4294967295");
}

TEST_CASE("masks: each must be in a group of the other's")
{
    CHECK(masks_meet(1, 2, 2, 1));
    CHECK(masks_meet(3, 4, 4, 2));
    CHECK(!masks_meet(1, 2, 2, 2));
    CHECK(!masks_meet(1, 1, 2, 1));
    CHECK(!masks_meet(1, 0, 1, 0xffffffff));
    CHECK(at_rest({.immovable = true}));
    CHECK(at_rest({.asleep = true}));
    CHECK(!at_rest({}));
}
