// SPDX-License-Identifier: BSD-3-Clause
#include "block_tree.h"

#include "parallel.h"

#include <algorithm>

namespace brink {

namespace {

constexpr std::size_t width = lanes;

constexpr Boxes no_boxes = [] {
    Boxes boxes{};
    for (int lane = 0; lane < lanes; ++lane)
        put(boxes, lane, empty_box);
    return boxes;
}();

std::size_t blocks_of(std::size_t items) { return (items + width - 1) / width; }

template <class T> std::size_t bytes_of(const std::vector<T>& v) { return v.capacity() * sizeof(T); }

} // namespace

Mask BlockTree::held(std::size_t leaf) const
{
    Mask mask = 0;
    for (std::size_t lane = 0; lane < width; ++lane)
        mask |= static_cast<Mask>(slots[width * leaf + lane] != no_slot) << lane;
    return mask;
}

void BlockTree::clear() { resize(0); }

void BlockTree::resize(std::size_t bodies)
{
    count = 0;
    height = 0;
    std::size_t blocks = blocks_of(bodies);
    balls.reserve(blocks); // no more than that, as assign does
    balls.resize(blocks);
    slots.assign(width * blocks, no_slot);
    for (auto& level : levels) {
        auto& ids = least[static_cast<std::size_t>(&level - levels.data())];
        level.assign(blocks, no_boxes);
        ids.assign(blocks, no_body);
        if (blocks > 0) ++height;
        blocks = blocks > 1 ? blocks_of(blocks) : 0;
    }
}

void BlockTree::set(std::size_t place, std::uint32_t slot, const Sweep& sweep)
{
    const std::size_t leaf = place / width;
    const auto lane = static_cast<int>(place % width);
    slots[place] = slot;
    put(levels[0][leaf], lane, sweep.box);
    put(balls[leaf], lane, sweep);
}

void BlockTree::erase(std::size_t place)
{
    slots[place] = no_slot;
    put(levels[0][place / width], static_cast<int>(place % width), empty_box);
    --count;
}

void BlockTree::bound(std::span<const BodyId> ids)
{
    for_each_part(leaves(), [&](std::size_t leaf) {
        BodyId lowest = no_body;
        for (std::size_t k = width * leaf; k < width * (leaf + 1); ++k)
            if (slots[k] != no_slot) lowest = std::min(lowest, ids[slots[k]]);
        least[0][leaf] = lowest;
    });
    for (std::size_t l = 1; l < static_cast<std::size_t>(height); ++l) {
        const std::vector<BodyId>& below = least[l - 1];
        for (std::size_t block = 0; block < least[l].size(); ++block) {
            const auto first = below.begin() + static_cast<std::ptrdiff_t>(width * block);
            const std::size_t held = std::min(width, below.size() - width * block);
            least[l][block] = *std::min_element(first, first + static_cast<std::ptrdiff_t>(held));
        }
    }
    refit();
}

void BlockTree::bound_groups(std::span<const Body> bodies)
{
    for (std::vector<Groups>& level : groups)
        level.clear();
    if (bodies.empty()) return;
    for (std::size_t l = 0; l < static_cast<std::size_t>(height); ++l)
        groups[l].assign(levels[l].size(), {0, 0});
    for_each_part(leaves(), [&](std::size_t leaf) {
        for (std::size_t k = width * leaf; k < width * (leaf + 1); ++k)
            if (slots[k] != no_slot)
                groups[0][leaf] = groups[0][leaf] | Groups{bodies[slots[k]].category, bodies[slots[k]].mask};
    });
    for (std::size_t l = 1; l < static_cast<std::size_t>(height); ++l)
        for (std::size_t k = 0; k < groups[l - 1].size(); ++k)
            groups[l][k / width] = groups[l][k / width] | groups[l - 1][k];
}

void BlockTree::refit()
{
    for (std::size_t l = 1; l < static_cast<std::size_t>(height); ++l) {
        const std::vector<Boxes>& below = levels[l - 1];
        for_each_part(levels[l].size(), [&](std::size_t block) {
            const std::size_t end = std::min(width * (block + 1), below.size());
            for (std::size_t k = width * block; k < end; ++k)
                put(levels[l][block], static_cast<int>(k % width), bound_of(below[k]));
        });
    }
}

double BlockTree::spread() const
{
    double sum = 0;
    for (const Boxes& bounds : levels[1]) {
        for (int lane = 0; lane < lanes; ++lane) {
            const Box3f b = box_at(bounds, lane);
            const float x = b.max[0] - b.min[0], y = b.max[1] - b.min[1], z = b.max[2] - b.min[2];
            const auto area = static_cast<double>(x * y + y * z + z * x);
            if (area < 0x1p120) sum += area; // not where nothing is known, nor of an empty lane
        }
    }
    return sum;
}

std::size_t BlockTree::bytes() const
{
    std::size_t sum = bytes_of(balls) + bytes_of(slots);
    for (const auto& level : levels)
        sum += bytes_of(level);
    for (const auto& ids : least)
        sum += bytes_of(ids);
    for (const auto& level : groups)
        sum += bytes_of(level);
    return sum;
}

} // namespace brink
