// SPDX-License-Identifier: BSD-3-Clause
#include "packet.h"

#include "support/moving.h"
#include "sweep_field.h"

#include <doctest/doctest.h>

using namespace brink;
using support::Random;

namespace {

/// Bodies of all kinds of rest and masks: slot i has id i.
BodyStore draw_store(Random& random, std::size_t n)
{
    BodyStore store;
    for (std::size_t i = 0; i < n; ++i) {
        Body body{Sphere{1}};
        body.immovable = random.chance(0.3);
        body.asleep = random.chance(0.3);
        body.category = 1U << random.index(3);
        if (random.chance(0.5)) body.mask = static_cast<std::uint32_t>(random.index(8));
        store.add(body);
    }
    return store;
}

Chunk chunk_of_all_pairs(std::uint32_t n)
{
    Chunk chunk;
    chunk.candidates.make_room(std::size_t{n} * n);
    for (std::uint32_t a = 0; a < n; ++a)
        for (std::uint32_t b = 0; b < n; ++b)
            if (a != b) chunk.candidates.set(chunk.candidates.count++, {a, b, 0.25F});
    return chunk;
}

struct Settled {
    std::size_t kept = 0;
    std::uint64_t skipped = 0, masked = 0, filtered = 0;
    friend bool operator==(const Settled&, const Settled&) = default;
};

bool filter(BodyId a, BodyId b) { return a < b && (a + b) % 3 != 0; }

/// What is to become of all pairs: the first layer that settles a pair counts it, if it is at work.
Settled expected(const BodyStore& store, Layers without)
{
    Settled s;
    for (BodyId i = 0; i < store.count(); ++i) {
        for (BodyId k = 0; k < store.count(); ++k) {
            if (i == k) continue;
            const Body &a = store.bodies[i], &b = store.bodies[k];
            const bool rest = (a.immovable || a.asleep) && (b.immovable || b.asleep);
            const bool scenery = a.immovable && b.immovable;
            const bool masked = (a.category & b.mask) == 0 || (b.category & a.mask) == 0;
            const bool filtered = !filter(std::min(i, k), std::max(i, k));
            if (rest) {
                ++(without.has(scenery ? Layer::immovable : Layer::asleep) ? s.kept : s.skipped);
            } else if (masked) {
                ++(without.has(Layer::mask) ? s.kept : s.masked);
            } else if (filtered) {
                ++(without.has(Layer::filter) ? s.kept : s.filtered);
            } else {
                ++s.kept;
            }
        }
    }
    return s;
}

} // namespace

TEST_CASE("drop_what_need_not_be_asked: settles each pair by the first layer that can, and counts it")
{
    Random random(8);
    const Scene::PairFilter user = filter;
    const Layers sets[] = {{},
                           Layer::immovable,
                           Layer::asleep,
                           Layer::mask,
                           Layer::filter,
                           Layer::mask | Layer::filter,
                           Layer::immovable | Layer::asleep | (Layer::mask | Layer::filter)};
    for (const Layers without : sets) {
        const BodyStore store = draw_store(random, 40);
        Chunk chunk = chunk_of_all_pairs(40);
        Plan plan;
        plan.filter = &user;
        plan.rest_pairs = true;
        plan.without = without;
        drop_what_need_not_be_asked(chunk, store, plan);
        CAPTURE(without.bits);
        CHECK(Settled{chunk.candidates.count, chunk.immovable + chunk.asleep, chunk.masked, chunk.filtered} ==
              expected(store, without));
        std::uint64_t meeting = 0;
        for (std::size_t i = 0; i < chunk.candidates.count; ++i) {
            CHECK(chunk.candidates[i].t == 0.25F);
            meeting += meets(chunk.candidates[i], store, plan) ? 1 : 0;
        }
        CHECK(meeting == expected(store, {}).kept); // whatever is switched off
        CHECK(meeting > 50);
    }
}

TEST_CASE("drop_what_need_not_be_asked: a cast has its own category and mask")
{
    Random random(9);
    const BodyStore picky = draw_store(random, 40);
    BodyStore plain;
    for (int i = 0; i < 40; ++i)
        plain.add({Sphere{1}});
    Packet cast;
    for (const BodyStore* store : {&picky, &std::as_const(plain)}) {
        for (std::uint32_t bits = 0; bits < 64; ++bits) {
            Plan plan;
            plan.alone = &cast;
            plan.category = bits % 8;
            plan.mask = bits / 8 == 7 ? 0xffffffff : bits / 8;
            Chunk chunk;
            chunk.candidates.make_room(40);
            std::size_t meet = 0;
            for (std::uint32_t slot = 0; slot < 40; ++slot) {
                const Body& b = store->bodies[slot];
                chunk.candidates.set(chunk.candidates.count++, {no_slot, slot, 0});
                meet += (plan.category & b.mask) != 0 && (b.category & plan.mask) != 0;
            }
            drop_what_need_not_be_asked(chunk, *store, plan);
            CAPTURE(plan.category);
            CAPTURE(plan.mask);
            CHECK(chunk.candidates.count == meet);
            CHECK(chunk.masked == 40 - meet);
        }
    }
}

TEST_CASE("make_packet: the bodies of a leaf, grown, and cut off where balls say when")
{
    const support::SweepField field = support::draw_field(100, 1, 2);
    Plan plan;
    plan.grown = 0.5;
    plan.rules.grown = 0.5F;
    Packet p, cut;
    int far = 0, smaller = 0;
    for (std::uint32_t leaf = 0; leaf < field.tree.leaves(); ++leaf) {
        make_packet(p, field.tree, leaf, plan);
        plan.rules.until = 0.25F;
        make_packet(cut, field.tree, leaf, plan);
        plan.rules.until = 1;
        CHECK(p.held == field.tree.held(leaf));
        CHECK(p.least == field.tree.least[0][leaf]);
        for (int lane = 0; lane < lanes; ++lane) {
            if ((p.held >> lane & 1U) == 0) continue;
            const std::uint32_t slot = p.slots[lane];
            CHECK(slot == field.tree.slots[16 * leaf + static_cast<std::uint32_t>(lane)]);
            const Sweep& s = field.sweeps[slot];
            const Box3f grown = box_at(p.boxes, lane), short_one = box_at(cut.boxes, lane);
            for (int axis = 0; axis < 3; ++axis) {
                CHECK(grown.min[axis] <= s.box.min[axis] - 0.5F);
                CHECK(grown.max[axis] >= s.box.max[axis] + 0.5F);
                CHECK(p.bound.min[axis] <= grown.min[axis]);
                CHECK(short_one.min[axis] >= grown.min[axis]);
                smaller += short_one.max[axis] < grown.max[axis];
                for (const float t : {0.0F, 0.25F}) {
                    const auto c = static_cast<double>(s.from[axis]) +
                                   static_cast<double>(t) * static_cast<double>(s.by[axis]);
                    const double r = static_cast<double>(s.radius) + 0.5;
                    CHECK(static_cast<double>(short_one.min[axis]) <= c - r);
                    CHECK(static_cast<double>(short_one.max[axis]) >= c + r);
                }
            }
            far += (p.far >> lane & 1U) != 0;
        }
    }
    CHECK(far > 10);
    CHECK(smaller > 50);
    const Packet one = packet_of(field.sweeps[0], plan);
    CHECK(one.held == 1);
    CHECK(one.slots[0] == no_slot);
    CHECK(one.bound.max[0] >= field.sweeps[0].box.max[0] + 0.5F);
}
