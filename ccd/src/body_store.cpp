// SPDX-License-Identifier: BSD-3-Clause
#include "body_store.h"

#include "block.h"

#include <stdexcept>
#include <string>

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

bool BodyStore::contains(BodyId id) const { return id < slots.size() && slots[id] != no_slot; }

std::uint32_t BodyStore::slot(BodyId id) const
{
    if (contains(id)) return slots[id];
    throw std::invalid_argument("brink::Scene: there is no body " + std::to_string(id) +
                                (id < slots.size() ? ": it was removed" : ""));
}

std::uint32_t BodyStore::add(const Body& body)
{
    if (slots.size() >= no_body)
        throw std::length_error("brink::Scene: as many bodies were added as there are ids");
    make_room(slots); // first: where there is no memory left the scene stays as it was
    if (free_slots.empty()) {
        make_room(bodies);
        make_room(ids);
        free_slots.reserve(bodies.capacity());
        bodies.push_back(body);
        ids.push_back(no_body);
        free_slots.push_back(static_cast<std::uint32_t>(bodies.size() - 1));
    } else {
        bodies[free_slots.back()] = body;
        reused = true;
    }
    const std::uint32_t slot = free_slots.back();
    free_slots.pop_back();
    ids[slot] = static_cast<BodyId>(slots.size());
    slots.push_back(slot);
    count(body, 1);
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
    slots[ids[slot]] = no_slot;
    ids[slot] = no_body;
    bodies[slot] = {};
    free_slots.push_back(slot); // there is room: it was taken from here
}

} // namespace brink
