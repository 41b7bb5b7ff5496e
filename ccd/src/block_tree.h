// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "block.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace brink {

/// A bounding volume hierarchy without pointers: leaves of sixteen bodies that lie near each other, and above
/// them, level by level, blocks of sixteen bounds; lane k of block i bounds block 16 i + k one level below.
struct BlockTree {
    static constexpr int max_levels = 9;                // 16^9 > 2^32
    std::array<std::vector<Boxes>, max_levels> levels;  // [0]: the leaves
    std::array<std::vector<BodyId>, max_levels> least;  // the lowest id within each block
    std::array<std::vector<Groups>, max_levels> groups; // of each block; empty where all may meet
    int height = 0;                                     // levels in use
    std::vector<Balls> balls;                           // of the leaves
    std::vector<std::uint32_t> slots;                   // sixteen a leaf; no_slot where there is no body
    std::size_t count = 0;                              // bodies
    bool still = false;                                 // they all rest

    std::size_t leaves() const { return levels[0].size(); }
    Mask held(std::size_t leaf) const;
    void clear();
    /// Room for so many bodies in a row, all lanes empty.
    void resize(std::size_t bodies);
    void set(std::size_t place, std::uint32_t slot, const Sweep&);
    void erase(std::size_t place);
    /// The levels above the leaves, from the leaves. ids: by slot.
    void bound(std::span<const BodyId> ids);
    /// What groups there are within the blocks. bodies: by slot; none where all may meet.
    void bound_groups(std::span<const Body> bodies);
    /// The same after bodies have moved or left: the lowest ids may be of some that left.
    void refit();
    Box3f bound_of_leaf(std::uint32_t leaf) const
    {
        if (height == 1) return bound_of(levels[0][leaf]);
        return box_at(levels[1][leaf / lanes], static_cast<int>(leaf % lanes));
    }
    /// The sum of the surfaces of the leaves' bounds: how well they keep together.
    double spread() const;
    std::size_t bytes() const;
};

} // namespace brink
