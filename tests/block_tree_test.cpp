// SPDX-License-Identifier: BSD-3-Clause
#include "block_tree.h"

#include "sweep_field.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

using namespace brink;
using support::Random;

namespace {

struct Below {
    Box3f box = empty_box;
    BodyId least = no_body;
    std::size_t count = 0;
};

/// What lies in some places of a tree, looked at one by one.
Below look(const BlockTree& tree, const std::vector<BodyId>& ids, std::size_t begin, std::size_t end)
{
    Below b;
    for (std::size_t place = begin; place < std::min(end, tree.slots.size()); ++place) {
        if (tree.slots[place] == no_slot) continue;
        const Box3f box = box_at(tree.levels[0][place / lanes], static_cast<int>(place % lanes));
        for (int axis = 0; axis < 3; ++axis) {
            b.box.min[axis] = b.count == 0 ? box.min[axis] : std::min(b.box.min[axis], box.min[axis]);
            b.box.max[axis] = b.count == 0 ? box.max[axis] : std::max(b.box.max[axis], box.max[axis]);
        }
        b.least = std::min(b.least, ids[tree.slots[place]]);
        ++b.count;
    }
    return b;
}

bool same(const Box3f& a, const Box3f& b)
{
    bool yes = true;
    for (int axis = 0; axis < 3; ++axis) {
        const bool empty = std::isnan(a.min[axis]) && std::isnan(b.min[axis]) && std::isnan(a.max[axis]) &&
                           std::isnan(b.max[axis]);
        yes = yes && (empty || (a.min[axis] == b.min[axis] && a.max[axis] == b.max[axis]));
    }
    return yes;
}

int wrong_bounds(const BlockTree& tree, const std::vector<BodyId>& ids)
{
    int wrong = 0;
    std::size_t under = lanes; // places under a block
    for (std::size_t l = 0; l < static_cast<std::size_t>(tree.height); ++l, under *= lanes) {
        for (std::size_t block = 0; block < tree.levels[l].size(); ++block) {
            wrong += tree.least[l][block] != look(tree, ids, block * under, (block + 1) * under).least;
            for (std::size_t lane = 0; l > 0 && lane < lanes; ++lane) {
                const std::size_t from = block * under + lane * (under / lanes);
                const Box3f held = box_at(tree.levels[l][block], static_cast<int>(lane));
                wrong += !same(held, look(tree, ids, from, from + under / lanes).box);
            }
        }
    }
    return wrong;
}

} // namespace

TEST_CASE("BlockTree: as many leaves and levels as there must be, all empty")
{
    BlockTree tree;
    CHECK(tree.height == 0);
    for (const std::size_t n : {0U, 1U, 16U, 17U, 256U, 257U, 4096U, 4097U, 70'000U}) {
        tree.resize(n);
        CAPTURE(n);
        CHECK(tree.count == 0);
        CHECK(tree.leaves() == (n + 15) / 16);
        CHECK(tree.slots.size() == 16 * tree.leaves());
        std::size_t blocks = tree.leaves(), levels = blocks > 0 ? 1 : 0;
        for (; blocks > 1; blocks = (blocks + 15) / 16)
            ++levels;
        CHECK(static_cast<std::size_t>(tree.height) == levels);
        if (n > 0) CHECK(tree.levels[levels - 1].size() == 1);
        int held = 0;
        for (std::size_t leaf = 0; leaf < tree.leaves(); ++leaf)
            held += tree.held(leaf) != 0 || !same(bound_of(tree.levels[0][leaf]), empty_box);
        CHECK(held == 0);
        CHECK(tree.bytes() >= tree.leaves() * (sizeof(Boxes) + sizeof(Balls) + 16 * sizeof(std::uint32_t)));
    }
    tree.clear();
    CHECK(tree.height == 0);
    CHECK(tree.leaves() == 0);
}

TEST_CASE("BlockTree: every level bounds what is below it and knows the lowest id there")
{
    int erased = 0;
    for (const std::size_t n : {1U, 16U, 17U, 100U, 300U, 5000U}) {
        support::SweepField field = support::draw_field(n, 1, n, 0.3);
        BlockTree& tree = field.tree;
        CAPTURE(n);
        CHECK(wrong_bounds(tree, field.ids) == 0);
        std::size_t held = 0;
        for (std::size_t leaf = 0; leaf < tree.leaves(); ++leaf)
            held += static_cast<std::size_t>(__builtin_popcount(tree.held(leaf)));
        CHECK(held == tree.count);
        CHECK(look(tree, field.ids, 0, tree.slots.size()).count == tree.count);
        erased += static_cast<int>(n - tree.count);
        for (std::size_t place = 0; place < n; ++place) { // put all back, and take whole leaves out
            if (tree.slots[place] == no_slot) ++tree.count;
            tree.set(place, static_cast<std::uint32_t>(place), field.sweeps[place]);
            if (place % 64 < 20) tree.erase(place);
        }
        tree.bound(field.ids);
        CHECK(wrong_bounds(tree, field.ids) == 0);
        CHECK(look(tree, field.ids, 0, tree.slots.size()).count == tree.count);
    }
    CHECK(erased > 1'000);
}

TEST_CASE("BlockTree: a leaf holds the sweeps it was given")
{
    const support::SweepField field = support::draw_field(300, 1, 8, 0);
    int wrong = 0;
    for (std::size_t place = 0; place < 300; ++place) {
        const Sweep& s = field.sweeps[field.tree.slots[place]];
        const Balls& balls = field.tree.balls[place / lanes];
        const std::size_t lane = place % lanes;
        wrong += !same(box_at(field.tree.levels[0][place / lanes], static_cast<int>(lane)), s.box);
        wrong += balls.radius[lane] != s.radius;
        for (int axis = 0; axis < 3; ++axis)
            wrong += balls.from[axis][lane] != s.from[axis] || balls.by[axis][lane] != s.by[axis];
    }
    CHECK(wrong == 0);
}

TEST_CASE("BlockTree: spread is the surface of the leaves, without those that are everywhere")
{
    BlockTree tree;
    tree.resize(48);
    std::vector<BodyId> ids(48);
    std::iota(ids.begin(), ids.end(), 0U);
    tree.set(0, 0, {.box = {{0, 0, 0}, {1, 1, 1}}});
    tree.set(1, 1, {.box = {{1, 1, 1}, {1, 2, 3}}});
    tree.set(16, 2, support::everywhere());
    tree.bound(ids);
    CHECK(tree.spread() == 1 * 2 + 2 * 3 + 3 * 1);
    tree.set(32, 3, {.box = {{0, 0, 0}, {2, 2, 2}}});
    tree.bound(ids);
    CHECK(tree.spread() == 11 + 12);
}
