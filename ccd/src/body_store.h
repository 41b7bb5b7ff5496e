// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/scene.h>

#include <span>
#include <vector>

namespace brink {

/// The bodies of a scene in slots, which are used again, and under ids, which are not.
struct BodyStore {
    std::vector<Body> bodies;         // by slot
    std::vector<BodyId> ids;          // by slot; no_body where the slot is free
    std::vector<std::uint32_t> slots; // by id, where reused; no_slot where the body is gone
    std::vector<std::uint32_t> free_slots;
    bool reused = false;                   // some slot has had more than one body: until then it is the id
    std::size_t picky = 0;                 // bodies whose mask leaves some group out
    std::size_t immovable = 0, asleep = 0; // bodies; who is both is immovable

    /// Asks memory for a body that will be needed soon: `ahead` of those in between.
    static constexpr std::size_t ahead = 8;
    void fetch(std::uint32_t slot) const
    {
        const auto* at = reinterpret_cast<const char*>(&bodies[slot]);
        for (std::size_t i = 0; i < sizeof(Body); i += 64)
            __builtin_prefetch(at + i);
    }
    std::size_t count() const { return bodies.size() - free_slots.size(); }
    /// Of the body in a slot. Does not ask memory for what is known without.
    BodyId id(std::uint32_t of_slot) const { return reused ? ids[of_slot] : of_slot; }
    /// That the next body will have.
    BodyId next_id() const { return static_cast<BodyId>(reused ? slots.size() : ids.size()); }
    /// Of a body that is there.
    std::uint32_t slot_of(BodyId of) const { return reused ? slots[of] : of; }
    bool contains(BodyId) const;
    /// Throws std::invalid_argument where there is no such body.
    std::uint32_t slot(BodyId) const;
    /// The body's slot; ids[slot] is its id.
    std::uint32_t add(Body);
    void replace(std::uint32_t slot, const Body&);
    void remove(std::uint32_t slot);

private:
    void make_table();
    void count(const Body&, std::size_t by);
};

static inline bool at_rest(const Body& b) { return b.immovable || b.asleep; }
/// Whether masks let two bodies meet.
static inline bool masks_meet(std::uint32_t category_a, std::uint32_t mask_a, std::uint32_t category_b,
                              std::uint32_t mask_b)
{
    return (category_a & mask_b) != 0 && (category_b & mask_a) != 0;
}

/// Whether a motion is valid for a body, which keeps its place if it rests.
bool fits(const Motion&, const Body& of);
/// Throw std::invalid_argument that names field, value and id where something is out of range.
void check(const Body&, BodyId);
void check(const Motion&, const Body& of, BodyId);
void check(const SceneOptions&);
void check_cast(const Shape&, const Motion&);
void check_ray(const Vec3& origin, const Vec3& direction, double t_max);

} // namespace brink
