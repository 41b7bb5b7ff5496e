// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "search.h"

#include <algorithm>
#include <stdexcept>

namespace brink {

/// A contact at which the two bodies, a < b, halt if nothing halts them before.
struct Halt {
    double t;
    BodyId a, b;
    BodyId halted; // which of them had already halted when this was asked; no_body where none had
};

/// The bodies, what is known of where they may be, and the memory of queries.
struct SceneData {
    BodyStore store;
    BroadPhase broad;
    Search search;
    Scene::PairFilter filter;
    Ledger ledger;
    bool busy = false;

    std::vector<Impact> impacts, ordered;
    struct Key {
        double t;
        BodyId a, b;
        std::uint32_t at;
    };
    std::vector<Key> keys;
    std::vector<BodyPair> pairs;
    std::vector<SafeTime> safe_times;
    std::vector<Halt> contacts; // of what moves, from the earliest on
    std::vector<Halt> halts;    // of what moves at what has halted: a heap
    std::vector<double> halted; // by slot: when; infinity while it moves
    std::vector<double> sure;   // by slot: a time by which it will have halted
    BlockTree moving;           // the movers that are not sure to halt at once
    std::vector<RayImpact> rays;
};

/// What became of the candidates that were handed on; the others were left open.
struct Asked {
    std::uint64_t exact = 0, late = 0;
};

/// While a query lasts: refuses what visitors and filters may not do, and brings the bounds up to date.
class Asking {
public:
    explicit Asking(SceneData&);
    ~Asking() { data_.busy = false; }
    Asking(const Asking&) = delete;
    Asking& operator=(const Asking&) = delete;

    /// For pairs that come within the band in which time_of_impact may answer a contact.
    Plan plan(const SceneOptions&) const;
    void write_ledger(const Plan&, const Asked&) const;

private:
    SceneData& data_;
};

/// time_of_impact of two bodies, the lower id first.
Impact ask(const BodyStore&, std::uint32_t slot_a, std::uint32_t slot_b, const Options&);

/// How many of a chunk's candidates may be asked.
static inline std::size_t allowed(const Chunk& chunk, const SceneOptions& options)
{
    const std::size_t room = options.max_tests - std::min(options.max_tests, chunk.before);
    return std::min(room, chunk.candidates.count);
}

/// Throws std::invalid_argument where there is none.
template <class Visitor> void check_visitor(const Visitor& visitor)
{
    if (!visitor) throw std::invalid_argument("brink::Scene: a visit was given an empty visitor");
}

/// The time until which a visitor wants to hear of more, after an answer; negative where of nothing.
static inline double narrowed(double until, double answer)
{
    return answer >= 0 ? std::min(until, answer) : -1; // NaN ends it too
}

static inline bool in_contact(const Toi& toi)
{
    return toi.status == Status::touching || toi.status == Status::hit || toi.status == Status::undecided;
}

static inline bool earlier(const Impact& x, const Impact& y)
{
    if (x.toi.t != y.toi.t) return x.toi.t < y.toi.t;
    return x.a != y.a ? x.a < y.a : x.b < y.b;
}
static inline bool earlier(const RayImpact& x, const RayImpact& y)
{
    return x.hit.t != y.hit.t ? x.hit.t < y.hit.t : x.body < y.body;
}

/// data.impacts, ordered by (t, a, b).
std::span<const Impact> in_order(SceneData&);

} // namespace brink
