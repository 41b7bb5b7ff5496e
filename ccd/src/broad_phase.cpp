// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase.h"

#include "parallel.h"
#include "place_order.h"
#include "placed_shape.h"
#include "sweep.h"

#include <algorithm>
#include <limits>

namespace brink {

namespace {

constexpr std::size_t width = lanes;

/// Leaves that take up this much more than when they were sorted are sorted again.
constexpr double come_apart = 1.5;

/// Arrivals are taken into the tree of what rests when they are more than this many, and an eighth of it.
constexpr std::size_t few_arrivals = 256;

/// Whether most lanes are empty.
bool sparse(const BlockTree& tree) { return 2 * (tree.count + width) < tree.slots.size(); }

Seat seat(std::size_t place, Home home)
{
    Seat s;
    s.place = static_cast<std::uint32_t>(place) & 0x0fffffffU;
    s.home = home;
    return s;
}

void reserve_more(std::vector<std::uint32_t>& list, std::size_t more)
{
    const std::size_t need = list.size() + more;
    if (need > list.capacity()) list.reserve(std::max(need, 2 * list.capacity()));
}

} // namespace

const BlockTree& BroadPhase::tree(Home home) const
{
    return home == Home::movers ? movers : home == Home::resting ? resting : arrived;
}

void BroadPhase::make_room(std::size_t slots)
{
    if (slots > seats_.capacity()) seats_.reserve(slots + slots / 8);
    for (auto* list : {&unbounded, &new_movers_, &new_resting_})
        reserve_more(*list, 1);
}

void BroadPhase::make_room_to_rest(std::size_t more) { reserve_more(new_resting_, more); }

void BroadPhase::add(std::uint32_t slot, const BodyStore& store)
{
    make_room(store.bodies.size());
    seats_.resize(store.bodies.size());
    if (!torn_) join(slot, store); // otherwise it is found with all others
}

void BroadPhase::join(std::uint32_t slot, const BodyStore& store)
{
    const Body& body = store.bodies[slot];
    if (brink::unbounded(body.shape)) {
        unbounded.push_back(slot);
        seats_[slot].home = Home::unbounded;
        return;
    }
    auto& joining = at_rest(body) ? new_resting_ : new_movers_;
    joining.push_back(slot);
    seats_[slot] = seat(joining.size() - 1, at_rest(body) ? Home::new_resting : Home::new_mover);
}

/// In its place comes the last.
void BroadPhase::take_out(std::vector<std::uint32_t>& joining, std::size_t place)
{
    const Home home = seats_[joining.back()].home;
    joining[place] = joining.back();
    seats_[joining[place]] = seat(place, home);
    joining.pop_back();
}

void BroadPhase::remove(std::uint32_t slot)
{
    const Seat from = seats_[slot];
    seats_[slot].home = Home::none;
    if (torn_) return; // it will not be found any more
    if (from.home == Home::unbounded)
        std::erase(unbounded, slot);
    else if (from.home == Home::new_mover)
        take_out(new_movers_, from.place);
    else if (from.home == Home::new_resting)
        take_out(new_resting_, from.place);
    else
        tree(from.home).erase(from.place);
}

void BroadPhase::moved(std::uint32_t slot, const BodyStore& store)
{
    if (torn_) return;
    if (is_mover(slot)) {
        movers.set(seats_[slot].place, slot, sweep(store.bodies[slot], origin));
    } else if (is_resting(slot)) {
        remove(slot);
        join(slot, store);
    }
}

Box3f BroadPhase::box(std::uint32_t slot) const
{
    constexpr float inf = std::numeric_limits<float>::infinity();
    const Seat seat = seats_[slot];
    if (seat.home == Home::unbounded) return {{-inf, -inf, -inf}, {inf, inf, inf}};
    return box_at(tree(seat.home).levels[0][seat.place / width], static_cast<int>(seat.place % width));
}

void BroadPhase::update(const BodyStore& store)
{
    if (torn_) start_over(store);
    torn_ = true; // where memory runs out on the way
    bring_up_to_date(store);
    torn_ = false;
}

void BroadPhase::start_over(const BodyStore& store)
{
    for (std::vector<std::uint32_t>* list : {&unbounded, &new_movers_, &new_resting_})
        list->clear();
    for (BlockTree* tree : {&movers, &resting, &arrived})
        tree->clear();
    for (std::uint32_t slot = 0; slot < store.bodies.size(); ++slot) {
        seats_[slot] = Seat{};
        if (store.ids[slot] != no_body) join(slot, store);
    }
}

void BroadPhase::bring_up_to_date(const BodyStore& store)
{
    const bool joined = !new_movers_.empty() || !new_resting_.empty();
    if (joined) {
        const V3 origin_before = origin;
        origin = origin_for(store, origin);
        if (!(origin == origin_before)) rebuild_all(store);
    }
    settle(store);
    if (!new_movers_.empty() || sparse(movers)) return build(movers, Home::movers, new_movers_, store);
    if (!bounds_moved_) return;
    movers.refit();
    bounds_moved_ = false;
    if (movers.spread() > come_apart * spread_when_built_) build(movers, Home::movers, new_movers_, store);
}

void BroadPhase::rebuild_all(const BodyStore& store)
{
    build(movers, Home::movers, new_movers_, store);
    build(resting, Home::resting, new_resting_, store);
    build(arrived, Home::arrived, new_resting_, store);
}

/// Takes in what came to rest.
void BroadPhase::settle(const BodyStore& store)
{
    if (sparse(resting)) build(resting, Home::resting, new_resting_, store);
    if (new_resting_.empty()) return;
    if (arrived.count + new_resting_.size() > few_arrivals + resting.count / 8) {
        for (const std::uint32_t slot : arrived.slots)
            if (slot != no_slot) new_resting_.push_back(slot);
        arrived.clear();
        build(resting, Home::resting, new_resting_, store);
    } else {
        build(arrived, Home::arrived, new_resting_, store);
    }
}

/// The tree from its own bodies and those that join it, sorted by place.
void BroadPhase::build(BlockTree& to, Home home, std::vector<std::uint32_t>& joining, const BodyStore& store)
{
    auto& keys = sorting_.keys;
    keys.clear();
    keys.reserve(to.count + joining.size());
    for (const std::uint32_t slot : to.slots)
        if (slot != no_slot) keys.push_back({0, slot});
    for (const std::uint32_t slot : joining)
        keys.push_back({0, slot});
    joining.clear();
    if (joining.capacity() > few_arrivals) joining.shrink_to_fit();
    sort_by_place(sorting_, store);

    to.resize(keys.size());
    to.count = keys.size();
    to.still = home != Home::movers;
    for_each_part(to.leaves(), [&](std::size_t leaf) {
        const std::size_t end = std::min(width * (leaf + 1), keys.size());
        for (std::size_t place = width * leaf; place < end; ++place) {
            const std::uint32_t slot = keys[place].slot;
            if (place + BodyStore::ahead < keys.size()) store.fetch(keys[place + BodyStore::ahead].slot);
            to.set(place, slot, sweep(store.bodies[slot], origin));
            seats_[slot] = seat(place, home);
        }
    });
    to.bound(store.ids);
    to.bound_groups(store.picky > 0 ? std::span<const Body>(store.bodies) : std::span<const Body>());
    if (home == Home::movers) {
        spread_when_built_ = to.spread();
        bounds_moved_ = false;
    }
}

std::size_t BroadPhase::bytes() const
{
    const auto held = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    return movers.bytes() + resting.bytes() + arrived.bytes() + held(unbounded) + held(seats_) +
           held(new_movers_) + held(new_resting_) + held(sorting_.keys) + held(sorting_.other);
}

} // namespace brink
