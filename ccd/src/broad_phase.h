// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "block_tree.h"
#include "body_store.h"
#include "place_order.h"
#include "vector.h"

#include <utility>
#include <vector>

namespace brink {

/// Where the broad phase keeps a body.
enum class Home : unsigned char { none, new_mover, new_resting, movers, resting, arrived, unbounded };
struct Seat {
    std::uint32_t place : 28 = 0; // in its tree, or in the list of those that will join it
    Home home : 3 = Home::none;
    bool named : 1 = false; // by the change that is being made
};

/// Where every body of a scene may be over the step.
///
/// Movers are in a tree whose bounds follow every step and built anew when its leaves have come apart. What
/// rests is in one that is only built when much has changed: what came to rest since then is in a small third
/// tree, what left it is an empty lane. Planes and half-spaces are in no tree.
struct BroadPhase {
    V3 origin;
    BlockTree movers, resting, arrived;
    std::vector<std::uint32_t> unbounded; // slots, in the order of their arrival

    /// The next body that is added needs no memory then, if there are so many slots with it.
    void make_room(std::size_t slots);
    /// Nor do so many that rest, when they are moved.
    void make_room_to_rest(std::size_t more);
    void add(std::uint32_t slot, const BodyStore&);
    void remove(std::uint32_t slot);
    /// Its motion is another than before. Side by side only for bodies in the movers' tree, then
    /// refit_later().
    void moved(std::uint32_t slot, const BodyStore&);
    std::size_t place(std::uint32_t slot) const { return seats_[slot].place; } // in its tree
    bool is_resting(std::uint32_t slot) const
    {
        return seats_[slot].home == Home::resting || seats_[slot].home == Home::arrived;
    }
    void refit_later() { bounds_moved_ = true; }
    bool is_mover(std::uint32_t slot) const { return seats_[slot].home == Home::movers; }
    /// Notes that a change names this body; false if it was noted already.
    bool name(std::uint32_t slot)
    {
        const bool before = seats_[slot].named;
        seats_[slot].named = true;
        return !before;
    }
    void forget_name(std::uint32_t slot) { seats_[slot].named = false; }
    /// Where memory runs out, the next update finds all bodies anew.
    void update(const BodyStore&);
    /// The bounds as held; after update().
    Box3f box(std::uint32_t slot) const;
    bool is_unbounded(std::uint32_t slot) const { return seats_[slot].home == Home::unbounded; }
    std::size_t bytes() const;

private:
    void build(BlockTree&, Home, std::vector<std::uint32_t>& joining, const BodyStore&);
    void join(std::uint32_t slot, const BodyStore&);
    void start_over(const BodyStore&);
    void bring_up_to_date(const BodyStore&);
    void rebuild_all(const BodyStore&);
    void settle(const BodyStore&);
    void take_out(std::vector<std::uint32_t>& joining, std::size_t place);
    const BlockTree& tree(Home) const;
    BlockTree& tree(Home home) { return const_cast<BlockTree&>(std::as_const(*this).tree(home)); }

    std::vector<Seat> seats_; // by slot
    std::vector<std::uint32_t> new_movers_, new_resting_;
    PlaceSorting sorting_;
    bool torn_ = false;         // an update was left half way: seats and trees need not hold
    bool bounds_moved_ = false; // of movers, since the levels above them were told
    double spread_when_built_ = 0;
};

} // namespace brink
