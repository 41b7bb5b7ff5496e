// SPDX-License-Identifier: BSD-3-Clause
// Safe times: what a body that has halted stands in the way of.
#include "scene_halts.h"

#include "packet.h"
#include "placed_shape.h"
#include "support.h"
#include "sweep.h"
#include "tolerance.h"

#include <brink/distance.h>

namespace brink {

namespace {

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

} // namespace

void Halts::look_again(std::uint32_t halted)
{
    const Body& b = data_.store.bodies[halted];
    if (following_ && data_.moving.count == 0 && unbounded_moving_ == 0) return;
    const Motion standing = Motion::still(b.motion.at(data_.halted[halted]));
    const BlockTree& moving = following_ ? data_.moving : data_.broad.movers;
    if (unbounded(b.shape)) {
        const Timed deciding(decide_seconds_);
        for (const std::uint32_t slot : moving.slots)
            if (slot != no_slot && moves(slot)) ask_again(halted, slot, standing, 0);
        return;
    }
    Plan plan = asking_.plan(options_);
    plan.category = b.category;
    plan.mask = b.mask;
    plan.movers = &moving;
    plan.only_movers = true;
    plan.with_unbounded = unbounded_moving_ > 0;
    plan.grown += 2 * pose_room(b);
    plan.rules.grown = round_up(plan.grown * tolerance::float_sums);
    const Packet packet = packet_of(sweep({b.shape, standing}, data_.broad.origin), plan);
    plan.alone = &packet;
    data_.search.run(
        data_.store, data_.broad, plan, [](Chunk&) {},
        [&](const Chunk& chunk) {
            for (std::size_t i = 0; i < chunk.candidates.count; ++i) {
                const Candidate c = chunk.candidates[i];
                if (moves(c.b)) ask_again(halted, c.b, standing, static_cast<double>(c.t));
            }
            return true;
        });
    search_seconds_ += data_.search.search_seconds;
    decide_seconds_ += data_.search.decide_seconds;
}

bool Halts::began_in_contact(std::uint32_t a, std::uint32_t b) const
{
    Options at_start = options_.pair;
    at_start.t_max = 0;
    at_start.start_contact = StartContact::report;
    at_start.detail = Detail::time_only;
    return brink::ask(data_.store, a, b, at_start).toi.status == Status::touching;
}

/// Whether two bodies that began in contact have been farther apart before t than rounding tells, whether or
/// not they are near each other again at t.
bool Halts::parted(std::uint32_t a, std::uint32_t b, double t, double room) const
{
    Options until_now = options_.pair;
    until_now.t_max = t;
    until_now.target_gap += 2 * room;
    until_now.start_contact = StartContact::ignore;
    until_now.detail = Detail::time_only;
    if (brink::ask(data_.store, a, b, until_now).toi.status != Status::separated) return true;
    const Body &x = data_.store.bodies[a], &y = data_.store.bodies[b];
    const double gap = distance(x.shape, x.motion.at(t), y.shape, y.motion.at(t)).gap;
    return !(gap <= options_.pair.target_gap + room);
}

/// What is asked of the contact in which two bodies may be when one of them halts. Contact that was left and
/// come back to is no longer the one at the start.
StartContact Halts::start_contact(std::uint32_t halted, std::uint32_t other, double room) const
{
    if (options_.pair.start_contact == StartContact::report) return StartContact::report;
    if (!began_in_contact(halted, other)) return StartContact::report;
    if (parted(halted, other, data_.halted[halted], room)) return StartContact::report;
    return options_.pair.start_contact;
}

void Halts::ask_again(std::uint32_t halted, std::uint32_t other, const Motion& standing, double not_before)
{
    const BodyId i = data_.store.ids[halted], k = data_.store.ids[other];
    const BodyId low = std::min(i, k), high = std::max(i, k);
    const Body &still = data_.store.bodies[halted], &moving = data_.store.bodies[other];
    const double t = data_.halted[halted], left = 1 - t, least = std::max(t, not_before);
    if (!(t < options_.pair.t_max) || data_.sure[other] <= least) return;
    if (data_.filter && !data_.filter(low, high)) return;
    if (!masks_meet(still.category, still.mask, moving.category, moving.mask)) return;
    if (spent()) return halts_surely(other, {least, low, high, i}); // nothing is known of them from now on
    ++again_;
    Options options = options_.pair;
    options.detail = Detail::time_only;
    options.t_max = std::min(1.0, (options.t_max - t) / left);
    const double room = pose_room(still) + pose_room(moving);
    options.target_gap += room;
    options.start_contact = start_contact(halted, other, room);
    const Motion rest = rest_of(moving.motion, t);
    const Toi toi = i < k ? time_of_impact(still.shape, standing, moving.shape, rest, options)
                          : time_of_impact(moving.shape, rest, still.shape, standing, options);
    if (toi.status == Status::separated) return;
    halts_surely(other, {t + toi.t * left * (1 - tolerance::quotient), low, high, i});
}

} // namespace brink
