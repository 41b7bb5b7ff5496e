// SPDX-License-Identifier: BSD-3-Clause
// Safe times: an account of halts in the order of their times. The earliest contact of all halts its bodies;
// what still moves is asked anew against what has halted, and that may halt it in its turn.
#include "packet.h"
#include "placed_shape.h"
#include "scene_data.h"
#include "support.h"
#include "sweep.h"
#include "tolerance.h"

#include <algorithm>

namespace brink {

namespace {

/// Later halts come first, as std::push_heap has it.
bool later(const Halt& x, const Halt& y)
{
    if (x.t != y.t) return x.t > y.t;
    return x.a != y.a ? x.a > y.a : x.b > y.b;
}

/// What the rounding of Motion::at may bring a body nearer than it is.
double pose_room(const Body& b)
{
    const Motion& m = b.motion;
    const double angle = norm(load(m.rotation));
    const double arm = sum_of_magnitudes(load(m.pivot)) + 2 * farthest_from_origin(b.shape);
    return tolerance::sweep_slack * (sum_of_magnitudes(load(m.start.position)) +
                                     sum_of_magnitudes(load(m.translation)) + (1 + angle) * arm);
}

/// The rest of a motion from t on, as a motion of its own.
Motion rest_of(const Motion& m, double t)
{
    Motion rest = m;
    rest.start = m.at(t);
    rest.translation = (1 - t) * m.translation;
    rest.rotation = (1 - t) * m.rotation;
    return rest;
}

class Halts {
public:
    Halts(SceneData& data, const SceneOptions& options, const Asking& asking)
        : data_(data), options_(options), asking_(asking)
    {
        data_.halted.assign(data_.store.bodies.size(), infinity);
        data_.halts.clear();
    }

    void find_first();
    /// Tells of each as it halts, until whoever listens wants to hear no more.
    template <class Tell> void let_all_halt(Tell tell);
    std::uint64_t again() const { return again_; }

private:
    const Body& body(std::uint32_t slot) const { return data_.store.bodies[slot]; }
    bool moves(std::uint32_t slot) const { return !at_rest(body(slot)) && data_.halted[slot] == infinity; }
    void push(const Halt& halt)
    {
        data_.halts.push_back(halt);
        std::push_heap(data_.halts.begin(), data_.halts.end(), later);
    }
    void look_again(std::uint32_t halted);
    void ask_again(std::uint32_t halted, std::uint32_t other, const Motion& standing);
    bool began_in_contact(std::uint32_t a, std::uint32_t b) const;
    bool spent() const { return exact_ + again_ >= options_.max_tests; }

    SceneData& data_;
    const SceneOptions& options_;
    const Asking& asking_;
    std::uint64_t exact_ = 0, again_ = 0;
};

/// The first contacts of all pairs, as if nothing halted. Pairs beyond the budget halt where their balls
/// meet.
void Halts::find_first()
{
    Plan plan = asking_.plan(options_);
    Options time_only = options_.pair;
    time_only.detail = Detail::time_only;
    data_.search.run(
        data_.store, data_.broad, plan,
        [&](Chunk& chunk) {
            chunk.impacts.clear();
            chunk.asked = 0;
            for (std::size_t i = 0; i < chunk.candidates.count; ++i) {
                const Candidate c = chunk.candidates[i];
                const bool open = chunk.before + i >= options_.max_tests;
                Impact impact{data_.store.id(c.a), data_.store.id(c.b), {}};
                if (open) {
                    impact.toi.status = Status::undecided;
                    impact.toi.t = static_cast<double>(c.t);
                } else {
                    impact = ask(data_.store, c.a, c.b, time_only);
                    ++chunk.asked;
                }
                if (in_contact(impact.toi) && (plan.without.bits == 0 || meets(c, data_.store, plan)))
                    chunk.impacts.push_back(impact);
            }
        },
        [&](const Chunk& chunk) {
            exact_ += chunk.asked;
            for (const Impact& i : chunk.impacts)
                push({i.toi.t, std::min(i.a, i.b), std::max(i.a, i.b), no_body});
            return true;
        });
    asking_.write_ledger(plan, {exact_, 0});
}

template <class Tell> void Halts::let_all_halt(Tell tell)
{
    double until = options_.pair.t_max;
    const auto halt = [&](std::uint32_t slot, const Halt& at) {
        data_.halted[slot] = at.t;
        until = std::min(until, tell(SafeTime{data_.store.id(slot), std::min(at.t, options_.pair.t_max)}));
    };
    while (!data_.halts.empty()) {
        const Halt first = data_.halts.front();
        if (first.t > until) return;
        std::pop_heap(data_.halts.begin(), data_.halts.end(), later);
        data_.halts.pop_back();
        const std::uint32_t a = data_.store.slots[first.a], b = data_.store.slots[first.b];
        // Told of a pair of which one has halted since: that one's halt asked anew.
        const auto as_told = [&](std::uint32_t slot, BodyId id) {
            return data_.halted[slot] == infinity || id == first.halted;
        };
        if (!as_told(a, first.a) || !as_told(b, first.b)) continue;
        const bool a_halts = moves(a), b_halts = moves(b);
        if (a_halts) halt(a, first);
        if (b_halts && until >= 0) halt(b, first);
        if (until < 0) return;
        if (a_halts) look_again(a);
        if (b_halts) look_again(b);
    }
}

/// All that still moves against a body that has just halted.
void Halts::look_again(std::uint32_t halted)
{
    const Motion standing = Motion::still(body(halted).motion.at(data_.halted[halted]));
    if (unbounded(body(halted).shape)) {
        for (std::uint32_t slot = 0; slot < data_.store.bodies.size(); ++slot)
            if (data_.store.ids[slot] != no_body && moves(slot) && !unbounded(body(slot).shape))
                ask_again(halted, slot, standing);
        return;
    }
    Plan plan = asking_.plan(options_);
    const Body& b = body(halted);
    plan.category = b.category;
    plan.mask = b.mask;
    plan.only_movers = true;
    plan.grown += 2 * pose_room(b);
    plan.rules.grown = round_up(plan.grown * tolerance::float_sums);
    const Packet packet = packet_of(sweep({b.shape, standing}, data_.broad.origin), plan);
    plan.alone = &packet;
    data_.search.run(
        data_.store, data_.broad, plan, [](Chunk&) {},
        [&](const Chunk& chunk) {
            for (std::size_t i = 0; i < chunk.candidates.count; ++i)
                if (moves(chunk.candidates.b[i])) ask_again(halted, chunk.candidates.b[i], standing);
            return true;
        });
}

bool Halts::began_in_contact(std::uint32_t a, std::uint32_t b) const
{
    if (options_.pair.start_contact == StartContact::report) return false; // they would have halted then
    Options at_start = options_.pair;
    at_start.t_max = 0;
    at_start.start_contact = StartContact::report;
    at_start.detail = Detail::time_only;
    return ask(data_.store, a, b, at_start).toi.status == Status::touching;
}

void Halts::ask_again(std::uint32_t halted, std::uint32_t other, const Motion& standing)
{
    const BodyId i = data_.store.ids[halted], k = data_.store.ids[other];
    const BodyId low = std::min(i, k), high = std::max(i, k);
    const Body &still = body(halted), &moving = body(other);
    if (data_.filter && !data_.filter(low, high)) return;
    if (!masks_meet(still.category, still.mask, moving.category, moving.mask)) return;
    const double t = data_.halted[halted], left = 1 - t;
    if (!(t < options_.pair.t_max)) return;
    if (spent()) return push({t, low, high, i}); // nothing is known of them from now on
    ++again_;
    Options options = options_.pair;
    options.detail = Detail::time_only;
    options.t_max = std::min(1.0, (options.t_max - t) / left);
    options.target_gap += pose_room(still) + pose_room(moving);
    if (!began_in_contact(halted, other)) options.start_contact = StartContact::report;
    const Motion rest = rest_of(moving.motion, t);
    const Toi toi = i < k ? time_of_impact(still.shape, standing, moving.shape, rest, options)
                          : time_of_impact(moving.shape, rest, still.shape, standing, options);
    if (toi.status == Status::separated) return;
    push({t + toi.t * left * (1 - tolerance::quotient), low, high, i});
}

template <class Tell> void find_safe_times(SceneData& data, const SceneOptions& options, Tell tell)
{
    check(options);
    const Asking asking(data);
    Halts halts(data, options, asking);
    halts.find_first();
    const Ledger ledger = data.ledger;
    halts.let_all_halt(tell);
    data.ledger = ledger;
    data.ledger.again = halts.again();
}

} // namespace

std::span<const SafeTime> Scene::safe_times(const SceneOptions& options)
{
    SceneData& data = *data_;
    find_safe_times(data, options, [](const SafeTime&) { return infinity; });
    data.safe_times.clear();
    for (BodyId id = 0; id < data.store.slots.size(); ++id) {
        const std::uint32_t slot = data.store.slots[id];
        if (slot != no_slot) data.safe_times.push_back({id, std::min(data.halted[slot], options.pair.t_max)});
    }
    return data.safe_times;
}

void Scene::visit_safe_times(const VisitorOf<SafeTime>& visitor, const SceneOptions& options)
{
    check_visitor(visitor);
    find_safe_times(*data_, options, std::cref(visitor));
}

} // namespace brink
