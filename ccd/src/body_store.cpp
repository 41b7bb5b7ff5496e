// SPDX-License-Identifier: BSD-3-Clause
#include "body_store.h"

#include "block.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace brink {

namespace {

/// For one more.
template <class T> void make_room(std::vector<T>& v)
{
    if (v.size() == v.capacity()) v.reserve(2 * v.size() + 16);
}

} // namespace

/// by: 1, or its negative to take back.
void BodyStore::count(const Body& b, std::size_t by)
{
    if (b.mask != 0xffffffff) picky += by;
    if (b.immovable)
        immovable += by;
    else if (b.asleep)
        asleep += by;
}

bool BodyStore::contains(BodyId id) const
{
    if (!reused) return id < ids.size() && ids[id] != no_body;
    return id < slots.size() && slots[id] != no_slot;
}

std::uint32_t BodyStore::slot(BodyId id) const
{
    if (contains(id)) return slot_of(id);
    throw std::invalid_argument("brink::Scene: there is no body " + std::to_string(id) +
                                (id < next_id() ? ": it was removed" : ""));
}

/// From now on slots are no longer ids.
void BodyStore::make_table()
{
    std::vector<std::uint32_t> table;
    table.reserve(ids.size() + 16);
    for (const BodyId id : ids)
        table.push_back(id == no_body ? no_slot : id);
    slots = std::move(table);
    reused = true;
}

/// A body by value: it may be one of ours, which move when there is to be room for one more.
std::uint32_t BodyStore::add(Body body)
{
    const BodyId id = next_id();
    if (id == no_body) throw std::length_error("brink::Scene: as many bodies were added as there are ids");
    // Room first: where there is no memory left the scene stays as it was.
    if (free_slots.empty()) {
        if (reused) make_room(slots);
        make_room(bodies);
        make_room(ids);
        free_slots.reserve(bodies.capacity());
        bodies.push_back(std::move(body));
        ids.push_back(no_body);
        free_slots.push_back(static_cast<std::uint32_t>(bodies.size() - 1));
    } else {
        if (!reused) make_table();
        make_room(slots);
        bodies[free_slots.back()] = std::move(body);
    }
    const std::uint32_t slot = free_slots.back();
    free_slots.pop_back();
    ids[slot] = id;
    if (reused) slots.push_back(slot);
    count(bodies[slot], 1);
    return slot;
}

void BodyStore::replace(std::uint32_t slot, const Body& body)
{
    count(bodies[slot], static_cast<std::size_t>(-1));
    bodies[slot] = body;
    count(body, 1);
}

void BodyStore::remove(std::uint32_t slot)
{
    count(bodies[slot], static_cast<std::size_t>(-1));
    if (reused) slots[ids[slot]] = no_slot;
    ids[slot] = no_body;
    bodies[slot] = {};
    free_slots.push_back(slot); // there is room: it was taken from here
}

} // namespace brink
