// SPDX-License-Identifier: BSD-3-Clause
#include "search.h"

#include "packet.h"
#include "unbounded.h"

#include <algorithm>
#include <numeric>

namespace brink {

namespace {

/// Rounds are the same on any number of threads: this many chunks at most, which bounds the memory too.
constexpr std::size_t most_chunks = 128;
/// Room for the candidates of a chunk.
constexpr std::size_t most_candidates = 2048;

const BlockTree* tree_of(const BroadPhase& broad, const Plan& plan, Group group)
{
    switch (group) {
    case Group::movers:
        return plan.movers ? plan.movers : &broad.movers;
    case Group::resting:
        return &broad.resting;
    case Group::arrived:
        return &broad.arrived;
    default:
        return nullptr;
    }
}

Group after(Group g) { return static_cast<Group>(static_cast<int>(g) + 1); }

} // namespace

std::span<const Candidate> by_time(Chunk& chunk, std::size_t count)
{
    chunk.by_time.clear();
    for (std::size_t i = 0; i < count; ++i)
        chunk.by_time.push_back(chunk.candidates[i]);
    std::sort(chunk.by_time.begin(), chunk.by_time.end(), [](const Candidate& x, const Candidate& y) {
        return x.t != y.t ? x.t < y.t : x.a != y.a ? x.a < y.a : x.b < y.b;
    });
    return chunk.by_time;
}

void Search::forget()
{
    counts = {};
    immovable = asleep = masked = filtered = 0;
    candidates = 0;
    complete = true;
    search_seconds = decide_seconds = 0;
}

void Search::begin(const BodyStore& store, const BroadPhase& broad, const Plan& plan)
{
    forget();
    pending_.clear();
    round_ = 0;
    fresh_ = 0;
    unbounded_move_ = std::any_of(broad.unbounded.begin(), broad.unbounded.end(),
                                  [&](std::uint32_t slot) { return !at_rest(store.bodies[slot]); });
    mover_leaves_ = static_cast<std::uint32_t>(tree_of(broad, plan, Group::movers)->leaves());
    resting_leaves_ = static_cast<std::uint32_t>(broad.resting.leaves());
    const bool rest = plan.rest_pairs || unbounded_move_;
    fresh_count_ = plan.alone ? 1 : mover_leaves_ + (rest ? resting_leaves_ + broad.arrived.leaves() : 0);
    stride_ = 1;
    if (plan.scattered) { // coprime, and far from any simple fraction of the whole
        stride_ = static_cast<std::uint64_t>(0.6180339887 * static_cast<double>(fresh_count_)) | 1U;
        while (std::gcd(stride_, std::max<std::uint64_t>(fresh_count_, 1)) != 1)
            stride_ += 2;
    }
}

Item Search::fresh_item(std::uint64_t index) const
{
    auto leaf = static_cast<std::uint32_t>(index * stride_ % fresh_count_);
    if (leaf < mover_leaves_) return {Group::movers, Group::movers, leaf, leaf};
    leaf -= mover_leaves_;
    if (leaf < resting_leaves_) return {Group::resting, Group::resting, leaf, leaf};
    leaf -= resting_leaves_;
    return {Group::arrived, Group::arrived, leaf, leaf};
}

bool Search::next_round(const Plan& plan)
{
    const std::size_t growth = std::min<std::size_t>(round_++, 7);
    const std::size_t chunk_limit = plan.scattered ? std::size_t{1} << growth : most_chunks;
    used_ = 0;
    while (used_ < chunk_limit && left() > 0) {
        if (chunks_.size() == used_) chunks_.emplace_back();
        Chunk& chunk = chunks_[used_++];
        const std::uint64_t per_chunk = plan.scattered ? std::min<std::uint64_t>(16, 1U << growth) : 16;
        chunk.item_count = 0;
        while (chunk.item_count < per_chunk && left() > 0) {
            Item& item = chunk.items[chunk.item_count++];
            if (pending_.empty()) {
                item = plan.alone ? Item{} : fresh_item(fresh_);
                ++fresh_;
            } else {
                item = pending_.back();
                pending_.pop_back();
            }
        }
    }
    return used_ > 0;
}

void Search::find(Chunk& chunk, const BodyStore& store, const BroadPhase& broad, const Plan& plan)
{
    Candidates& to = chunk.candidates;
    to.make_room(most_candidates);
    chunk.counts = {};
    chunk.immovable = chunk.asleep = chunk.masked = chunk.filtered = 0;
    const Join join = plan.wide ? widest_join() : plain_join();
    Packet own;
    for (chunk.items_done = 0; chunk.items_done < chunk.item_count; ++chunk.items_done) {
        Item& item = chunk.items[chunk.items_done];
        if (!plan.alone) make_packet(own, *tree_of(broad, plan, item.source), item.leaf, plan);
        const Packet& packet = plan.alone ? *plan.alone : own;
        for (; item.against <= Group::unbounded; item.against = after(item.against), item.next = 0) {
            std::uint32_t stop = no_leaf;
            const bool self = !plan.alone && item.against == item.source;
            if (plan.only_movers && (item.against == Group::resting || item.against == Group::arrived))
                continue;
            if (item.against == Group::unbounded && !plan.with_unbounded) continue;
            if (item.against == Group::unbounded)
                stop = unbounded_candidates(packet, item, store, broad, plan, to, chunk.counts);
            else if (item.source == Group::movers || plan.rest_pairs)
                stop = join(packet, *tree_of(broad, plan, item.against), self ? item.leaf : no_leaf,
                            item.next, plan.rules, to, chunk.counts);
            if (stop == no_leaf) continue;
            item.next = stop;
            return drop_what_need_not_be_asked(chunk, store, plan);
        }
    }
    drop_what_need_not_be_asked(chunk, store, plan);
}

void Search::end_finding()
{
    for (std::size_t i = used_; i-- > 0;) // the last first: they are taken from the end
        for (std::size_t k = chunks_[i].item_count; k-- > chunks_[i].items_done;)
            pending_.push_back(chunks_[i].items[k]);
    for (std::size_t i = 0; i < used_; ++i) {
        Chunk& c = chunks_[i];
        c.before = candidates;
        candidates += c.candidates.count;
        counts.met += c.counts.met;
        counts.receding += c.counts.receding;
        counts.spheres += c.counts.spheres;
        counts.late += c.counts.late;
        immovable += c.immovable;
        asleep += c.asleep;
        masked += c.masked;
        filtered += c.filtered;
    }
}

} // namespace brink
