// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "broad_phase.h"
#include "join.h"
#include "parallel.h"
#include "timed.h"

#include <array>
#include <vector>

namespace brink {

/// Which bodies a packet is made of, and against which it is asked.
enum class Group : unsigned char { movers, resting, arrived, unbounded };

/// One packet of a search and how far it has come: the group, and the leaf or the unbounded body in it, to go
/// on at.
struct Item {
    Group source = Group::movers, against = Group::movers;
    std::uint32_t leaf = 0, next = 0;
};

/// Some items that one thread works through, and what came of them.
struct Chunk {
    std::array<Item, 16> items;
    std::size_t item_count = 0;
    std::size_t items_done = 0;
    Candidates candidates;
    JoinCounts counts;
    std::uint64_t immovable = 0, asleep = 0, masked = 0, filtered = 0; // candidates that need not be asked
    std::size_t before = 0;         // candidates of the search in earlier chunks
    std::vector<Candidate> by_time; // them, where the earliest is to be asked first
    std::vector<Impact> impacts;    // what was decided of them
    std::uint64_t asked = 0;        // how many were asked exactly
    std::size_t left = 0;           // how many were left open
    std::uint64_t late = 0;         // how many did not matter any more
};

/// A chunk's first candidates in the order of their times.
std::span<const Candidate> by_time(Chunk&, std::size_t count);

/// What a search asks, and of which pairs.
struct Plan {
    JoinRules rules{};
    double grown = 0;        // bodies that come this near count as meeting
    bool scattered = false;  // packets from all over the scene, few at first: for early answers
    bool rest_pairs = false; // pairs of bodies at rest as well
    bool wide = true;        // the instructions this machine has
    Layers without{};
    const Scene::PairFilter* filter = nullptr;
    bool with_unbounded = true;
    bool with_balls = true;            // packets are given them: the rules ask for them, or the unbounded do
    bool only_movers = false;          // against them and against what is unbounded
    const BlockTree* movers = nullptr; // in place of the broad phase's: some have been taken out
    bool bounded_only = false;         // a plane or half-space is cast
    const Packet* alone = nullptr;     // a shape that is cast, or a ray, in place of the scene's own bodies
    std::uint32_t category = 1, mask = 0xffffffff; // its own
};

/// The pairs of a scene that may meet, found side by side in chunks and handed on in an order that does not
/// depend on how many threads there are. Keeps its memory.
class Search {
public:
    JoinCounts counts;
    std::uint64_t immovable = 0, asleep = 0, masked = 0, filtered = 0;
    std::size_t candidates = 0; // that were handed on
    bool complete = true;
    double search_seconds = 0, decide_seconds = 0;

    /// Finds candidates round by round. `prepare` is told how many there are up to then; `decide` is called
    /// for the chunks of a round side by side, then `take` for one after the other, until it returns false.
    /// There `plan` may be made narrower.
    template <class Prepare, class Decide, class Take>
    void run(const BodyStore& store, const BroadPhase& broad, Plan& plan, Prepare prepare, Decide decide,
             Take take)
    {
        plan.with_balls = plan.rules.balls || (plan.with_unbounded && !broad.unbounded.empty());
        begin(store, broad, plan);
        while (next_round(plan)) {
            {
                const Timed searching(search_seconds);
                for_each_part(
                    used_, [&](std::size_t i) { find(chunks_[i], store, broad, plan); }, 1);
                end_finding();
                prepare(candidates);
            }
            const Timed deciding(decide_seconds);
            for_each_part(
                used_, [&](std::size_t i) { decide(chunks_[i]); }, 1);
            bool more = true;
            for (std::size_t i = 0; i < used_ && more; ++i)
                more = take(chunks_[i]);
            complete = more && left() == 0;
            if (!more) return;
        }
    }
    template <class Decide, class Take>
    void run(const BodyStore& store, const BroadPhase& broad, Plan& plan, Decide decide, Take take)
    {
        run(
            store, broad, plan, [](std::size_t) {}, decide, take);
    }
    /// As if nothing had been searched.
    void forget();

private:
    void begin(const BodyStore&, const BroadPhase&, const Plan&);
    bool next_round(const Plan&);
    static void find(Chunk&, const BodyStore&, const BroadPhase&, const Plan&);
    void end_finding();
    Item fresh_item(std::uint64_t index) const;
    std::uint64_t left() const { return pending_.size() + (fresh_count_ - fresh_); }

    std::vector<Chunk> chunks_;
    std::size_t used_ = 0, round_ = 0;
    std::vector<Item> pending_; // unfinished, the next one last
    std::uint64_t fresh_ = 0, fresh_count_ = 0, stride_ = 1;
    std::uint32_t mover_leaves_ = 0, resting_leaves_ = 0;
    bool unbounded_move_ = false;
};

} // namespace brink
