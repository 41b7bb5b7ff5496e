// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "block_tree.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// Sixteen bodies at once against a tree: which of its bodies each may meet.
namespace brink {

/// What is asked of the tree: boxes and balls of sixteen bodies, grown by what counts as contact.
struct Packet {
    Boxes boxes{};
    Balls balls{};
    Mask held = 0; // lanes with a body
    Mask far =
        0; // of those, the ones that travel far for their size: their path is looked at, not only its box
    Box3f bound = empty_box;
    bool dense = false;     // the boxes fill the bound well enough to stand for it
    BodyId least = no_body; // the lowest id
    Groups groups;          // of all of them
    std::uint32_t slots[lanes]{};
};

struct JoinRules {
    bool boxes = true;                                 // cull by them
    bool balls = true;                                 // cull by them
    bool receding = true, spheres = true, late = true; // which of the three ways
    bool times = true;                                 // candidates' times are asked for
    float grown = 0;                                   // balls that come this near count as meeting
    float until = 1;                                   // meetings later than this are late
    float follow = 1;                                  // 0: the tree's bodies stand still at their start
    bool groups = false;                               // blocks that exclude each other are left out
    BodyId below = no_body; // pairs of which neither id is at most this do not matter
};

/// Two bodies that may meet, and a time before which they do not.
struct Candidate {
    std::uint32_t a, b; // slots
    float t;
};

struct JoinCounts {
    std::uint64_t met = 0; // pairs whose boxes overlap
    std::uint64_t receding = 0, spheres = 0, late = 0;
};

/// Candidates in the order found, side by side. Never grows while it is filled.
struct Candidates {
    std::vector<std::uint32_t> a, b;
    std::vector<float> t;
    std::size_t count = 0;

    void make_room(std::size_t most)
    {
        a.resize(most), b.resize(most), t.resize(most);
        count = 0;
    }
    /// For all pairs of two leaves, and for a store of sixteen at the end of them.
    bool has_room() const { return count + std::size_t{lanes} * (lanes + 1) <= a.size(); }
    Candidate operator[](std::size_t i) const { return {a[i], b[i], t[i]}; }
    void set(std::size_t i, const Candidate& c) { a[i] = c.a, b[i] = c.b, t[i] = c.t; }
};

inline constexpr std::uint32_t no_leaf = 0xffffffff;

/// The packet against all leaves from `first` on, and where `own` is one of them against itself (each pair
/// once). Returns the leaf at which there was no room left for what may come, or no_leaf at the end.
using Join = std::uint32_t (*)(const Packet&, const BlockTree&, std::uint32_t own, std::uint32_t first,
                               const JoinRules&, Candidates&, JoinCounts&);

/// The widest that this machine can run. All find the same candidates in the same order.
Join widest_join();
/// The one that every machine can run.
Join plain_join();

} // namespace brink
