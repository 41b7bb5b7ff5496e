// SPDX-License-Identifier: BSD-3-Clause
// Safe times: which contacts are known, and what they make sure of.
#include "scene_halts.h"

#include "packet.h"
#include "placed_shape.h"
#include "sweep.h"

namespace brink {

namespace {

/// Room for contacts, for each body and in all.
constexpr std::size_t contacts_a_body = 4, few_contacts = 4096;

bool sooner(const Halt& x, const Halt& y) { return later(y, x); }

/// The one of the two that halts then whatever else halts, because the other stands still; no_slot where
/// both move.
std::uint32_t sure_to_halt(const Halt& h, const BodyStore& store)
{
    const std::uint32_t a = store.slot_of(h.a), b = store.slot_of(h.b);
    if (h.halted == h.a || at_rest(store.bodies[a])) return b;
    if (h.halted == h.b || at_rest(store.bodies[b])) return a;
    return no_slot;
}

} // namespace

Halts::Halts(SceneData& data, const SceneOptions& options, const Asking& asking)
    : data_(data),
      options_(options),
      asking_(asking),
      most_contacts_(contacts_a_body * data.store.count() + few_contacts)
{
    data_.halted.assign(data_.store.bodies.size(), infinity);
    data_.halts.clear();
    for (const std::uint32_t slot : data_.broad.unbounded)
        unbounded_moving_ += moves(slot) ? 1 : 0;
}

/// The time by which one of the two will have halted: a later contact comes to nothing, or is asked anew.
double Halts::sure(const Halt& h) const
{
    return std::min(data_.sure[data_.store.slot_of(h.a)], data_.sure[data_.store.slot_of(h.b)]);
}

void Halts::note_sure(const Halt& h)
{
    const std::uint32_t slot = sure_to_halt(h, data_.store);
    if (slot != no_slot && moves(slot)) data_.sure[slot] = std::min(data_.sure[slot], h.t);
}

/// From what is known now.
void Halts::find_sure()
{
    data_.sure.assign(data_.store.bodies.size(), infinity);
    for (const Halt& h : data_.halts)
        note_sure(h);
    for (const Halt& h : data_.contacts)
        note_sure(h);
}

void Halts::find_contacts(double until)
{
    if (cut_) now_ = cut_->t;
    cut_.reset();
    at_ = 0;
    data_.contacts.clear();
    find_sure();
    Plan plan = asking_.plan(options_);
    if (plan.rules.late) plan.rules.until = std::min(plan.rules.until, round_up(until));
    if (following_) {
        data_.moving.refit();
        plan.movers = &data_.moving;
    }
    const std::size_t room = options_.max_tests - std::min<std::size_t>(options_.max_tests, exact_ + again_);
    Asked asked;
    data_.search.run(
        data_.store, data_.broad, plan, [&](Chunk& chunk) { ask(chunk, plan, room); },
        [&](const Chunk& chunk) {
            asked.exact += chunk.asked;
            asked.late += chunk.late;
            for (const Impact& i : chunk.impacts)
                keep({std::max(i.toi.t, now_), std::min(i.a, i.b), std::max(i.a, i.b), no_body});
            if (data_.contacts.size() > most_contacts_) thin_out(plan);
            return true;
        });
    std::sort(data_.contacts.begin(), data_.contacts.end(), sooner);
    if (!searched_) asking_.write_ledger(plan, asked);
    (searched_ ? again_ : exact_) += asked.exact;
    searched_ = true;
    search_seconds_ += data_.search.search_seconds;
    decide_seconds_ += data_.search.decide_seconds;
}

void Halts::ask(Chunk& chunk, const Plan& plan, std::size_t room) const
{
    Options time_only = options_.pair;
    time_only.detail = Detail::time_only;
    chunk.impacts.clear();
    chunk.asked = chunk.late = 0;
    for (std::size_t i = 0; i < chunk.candidates.count; ++i) {
        const Candidate c = chunk.candidates[i];
        if (std::min(data_.halted[c.a], data_.halted[c.b]) < infinity) continue; // a plane that has halted
        const BodyId a = data_.store.id(c.a), b = data_.store.id(c.b);
        Impact impact{a, b, {}};
        impact.toi.status = Status::undecided;
        impact.toi.t = static_cast<double>(c.t);
        const Halt least{std::max(impact.toi.t, now_), std::min(a, b), std::max(a, b), no_body};
        if (plan.rules.late && (least.t > sure(least) || (cut_ && later(least, *cut_)))) {
            ++chunk.late;
            continue;
        }
        if (chunk.before + i < room) {
            impact = brink::ask(data_.store, c.a, c.b, time_only);
            ++chunk.asked;
        }
        if (in_contact(impact.toi) && (plan.without.bits == 0 || meets(c, data_.store, plan)))
            chunk.impacts.push_back(impact);
    }
}

void Halts::keep(const Halt& h)
{
    if (h.t > sure(h) || (cut_ && later(h, *cut_))) return;
    data_.contacts.push_back(h);
    note_sure(h);
}

/// Of too many contacts the earlier quarter is kept, and no later one is looked for.
void Halts::thin_out(Plan& plan)
{
    std::vector<Halt>& all = data_.contacts;
    std::erase_if(all, [&](const Halt& h) { return h.t > sure(h); });
    if (all.size() <= most_contacts_ / 2) return;
    const auto last = static_cast<std::ptrdiff_t>(most_contacts_ / 4);
    std::nth_element(all.begin(), all.begin() + last, all.end(), sooner);
    cut_ = all[static_cast<std::size_t>(last)];
    all.erase(all.begin() + last + 1, all.end());
    find_sure();
    if (!plan.rules.late) return;
    plan.rules.until = std::min(plan.rules.until, round_up(cut_->t));
    if (cut_->t == 0) plan.rules.below = cut_->a;
}

bool Halts::as_told(const Halt& h) const
{
    // Told of a pair of which one has halted since: that one's halt asked anew.
    const auto still_so = [&](BodyId id) {
        return data_.halted[data_.store.slot_of(id)] == infinity || id == h.halted;
    };
    return still_so(h.a) && still_so(h.b);
}

std::optional<Halt> Halts::next()
{
    std::vector<Halt>& halts = data_.halts;
    const bool again = !halts.empty() && !(cut_ && later(halts.front(), *cut_));
    if (at_ < data_.contacts.size() && !(again && later(data_.contacts[at_], halts.front())))
        return data_.contacts[at_++];
    if (!again) return std::nullopt;
    std::pop_heap(halts.begin(), halts.end(), later);
    const Halt first = halts.back();
    halts.pop_back();
    return first;
}

void Halts::halts_surely(std::uint32_t slot, const Halt& h)
{
    if (!(h.t < data_.sure[slot])) return;
    data_.sure[slot] = h.t;
    std::vector<Halt>& halts = data_.halts;
    if (halts.size() > 2 * data_.store.count() + few_contacts) { // of each body the earliest is in force
        std::erase_if(halts, [&](const Halt& old) {
            const std::uint32_t of = sure_to_halt(old, data_.store);
            return !moves(of) || old.t > data_.sure[of];
        });
        std::make_heap(halts.begin(), halts.end(), later);
    }
    halts.push_back(h);
    std::push_heap(halts.begin(), halts.end(), later);
    if (h.t <= data_.halted[data_.store.slot_of(h.halted)]) take_out(slot); // it halts at once
}

void Halts::halt(std::uint32_t slot, double t)
{
    data_.halted[slot] = t;
    if (data_.broad.is_mover(slot))
        take_out(slot);
    else
        --unbounded_moving_;
}

/// Of the tree of what moves, which is a copy of the movers' that is made before the first of them halts.
void Halts::take_out(std::uint32_t slot)
{
    BlockTree& moving = data_.moving;
    if (!following_) moving = data_.broad.movers;
    following_ = true;
    const std::size_t place = data_.broad.place(slot);
    if (!data_.broad.is_mover(slot) || moving.slots[place] != slot) return;
    moving.erase(place);
    if (++taken_out_ <= moving.count) return;
    moving.refit();
    taken_out_ = 0;
}

} // namespace brink
