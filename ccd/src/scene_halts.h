// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene_data.h"

#include <algorithm>
#include <optional>

namespace brink {

/// An account of halts in the order of their times. The earliest contact of all halts its bodies; what still
/// moves is asked anew against what has halted, and that may halt it in its turn.
///
/// Contacts of bodies that both move, which may come to nothing, are kept for a stretch of time only, as many
/// as a few for each body; what lies beyond is looked for when that time has come. A body's contact with one
/// that stands still is sure: of these the earliest is all that need be kept.
class Halts {
public:
    Halts(SceneData&, const SceneOptions&, const Asking&);

    /// Tells of each as it halts, until whoever listens wants to hear no more; then writes the ledger.
    template <class Tell> void let_all_halt(Tell tell);

private:
    bool moves(std::uint32_t slot) const
    {
        return !at_rest(data_.store.bodies[slot]) && data_.halted[slot] == infinity;
    }
    bool spent() const { return exact_ + again_ >= options_.max_tests; }
    double sure(const Halt&) const;
    bool as_told(const Halt&) const;
    /// The earliest of all that is known, before the cut.
    std::optional<Halt> next();

    /// The first contacts of what moves, as if nothing else halted, from now on and for as long as there is
    /// room. Pairs beyond the budget halt where their balls meet.
    void find_contacts(double until);
    void ask(Chunk&, const Plan&, std::size_t room) const;
    void keep(const Halt&);
    void thin_out(Plan&);
    void find_sure();
    void note_sure(const Halt&);

    void halt(std::uint32_t slot, double t);
    void take_out(std::uint32_t slot);
    /// All that still moves against a body that has just halted.
    void look_again(std::uint32_t halted);
    void ask_again(std::uint32_t halted, std::uint32_t other, const Motion& standing, double not_before);
    StartContact start_contact(std::uint32_t halted, std::uint32_t other, double room) const;
    bool began_in_contact(std::uint32_t a, std::uint32_t b) const;
    bool parted(std::uint32_t a, std::uint32_t b, double t, double room) const;
    void halts_surely(std::uint32_t slot, const Halt&);

    SceneData& data_;
    const SceneOptions& options_;
    const Asking& asking_;
    const std::size_t most_contacts_;
    std::size_t at_ = 0;      // in the contacts
    std::optional<Halt> cut_; // contacts later than this are left for another search
    double now_ = 0;          // of this search: what moves has met nothing before
    bool searched_ = false, following_ = false;
    std::size_t unbounded_moving_ = 0;
    std::size_t taken_out_ = 0; // since the tree of what moves was told
    std::uint64_t exact_ = 0, again_ = 0;
    double all_seconds_ = 0, search_seconds_ = 0, decide_seconds_ = 0;
};

/// Later halts come first, as std::push_heap has it.
static inline bool later(const Halt& x, const Halt& y)
{
    if (x.t != y.t) return x.t > y.t;
    return x.a != y.a ? x.a > y.a : x.b > y.b;
}

template <class Tell> void Halts::let_all_halt(Tell tell)
{
    const double t_max = options_.pair.t_max;
    double until = t_max;
    const auto halt_and_tell = [&](std::uint32_t slot, double t) {
        halt(slot, t);
        until = narrowed(until, tell(SafeTime{data_.store.id(slot), std::min(t, t_max)}));
    };
    const auto process = [&](const Halt& first) {
        const std::uint32_t a = data_.store.slot_of(first.a), b = data_.store.slot_of(first.b);
        const bool a_halts = moves(a), b_halts = moves(b);
        if (a_halts) halt_and_tell(a, first.t);
        if (b_halts && until >= 0) halt_and_tell(b, first.t);
        if (a_halts && until >= 0) look_again(a);
        if (b_halts && until >= 0) look_again(b);
    };
    {
        const Timed all(all_seconds_);
        do {
            find_contacts(until);
            while (const std::optional<Halt> first = next()) {
                if (first->t > until) until = -1;
                if (until < 0) break;
                if (as_told(*first)) process(*first);
            }
        } while (cut_ && until >= cut_->t);
    }
    Ledger& ledger = data_.ledger;
    ledger.again = again_;
    ledger.search_seconds = search_seconds_;
    ledger.exact_seconds = decide_seconds_;
    ledger.order_seconds = std::max(0.0, all_seconds_ - search_seconds_ - decide_seconds_);
}

} // namespace brink
