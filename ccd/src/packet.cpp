// SPDX-License-Identifier: BSD-3-Clause
#include "packet.h"

#include "sweep.h"
#include "tolerance.h"

#include <cmath>

namespace brink {

namespace {

/// A path this many radii long is looked at apart from its box.
constexpr float long_path = 8;

/// A packet is dense if its bound is at most this many of its boxes long.
constexpr float filling = 6;

float magnitude(const Balls& b, int lane)
{
    return std::fabs(b.by[0][lane]) + std::fabs(b.by[1][lane]) + std::fabs(b.by[2][lane]);
}

/// Whether boxes are not much smaller than their bound along each axis.
bool fill(const Boxes& boxes, const Box3f& bound)
{
    for (int axis = 0; axis < 3; ++axis) {
        float part[4]{}; // one sum would wait for itself
        for (int lane = 0; lane < lanes; lane += 4)
            for (int i = 0; i < 4; ++i) {
                const float length = boxes.max[axis][lane + i] - boxes.min[axis][lane + i];
                part[i] += length > 0 ? length : 0;
            }
        const float sum = (part[0] + part[1]) + (part[2] + part[3]);
        if (!(filling * sum >= lanes * (bound.max[axis] - bound.min[axis]))) return false;
    }
    return true;
}

void grow(Boxes& boxes, float by)
{
    const auto room = [by](float x) { return by + (std::fabs(x) + by) * tolerance::float_outwards; };
    for (int axis = 0; axis < 3; ++axis) {
        for (int lane = 0; lane < lanes; ++lane) {
            boxes.min[axis][lane] -= room(boxes.min[axis][lane]);
            boxes.max[axis][lane] += room(boxes.max[axis][lane]);
        }
    }
}

/// Cuts boxes down to what the balls pass until a time.
void cut_off(Boxes& boxes, const Balls& balls, float until, float grown)
{
    for (int axis = 0; axis < 3; ++axis) {
        for (int lane = 0; lane < lanes; ++lane) {
            const float from = balls.from[axis][lane], to = from + until * balls.by[axis][lane];
            const float r = balls.radius[lane] + grown;
            const float room = r + (std::fabs(from) + std::fabs(to) + r) * tolerance::ball_slack;
            const float low = (from < to ? from : to) - room, high = (from < to ? to : from) + room;
            if (low > boxes.min[axis][lane]) boxes.min[axis][lane] = low;
            if (high < boxes.max[axis][lane]) boxes.max[axis][lane] = high;
        }
    }
}

enum class Settled : unsigned char { no, immovable, asleep, mask, filter };

Settled settled(const Candidate& c, const BodyStore& store, const Plan& plan)
{
    const Body& b = store.bodies[c.b];
    if (plan.alone) {
        const bool meet = masks_meet(plan.category, plan.mask, b.category, b.mask);
        return meet ? Settled::no : Settled::mask;
    }
    const Body& a = store.bodies[c.a];
    if (at_rest(a) && at_rest(b)) return a.immovable && b.immovable ? Settled::immovable : Settled::asleep;
    if (!masks_meet(a.category, a.mask, b.category, b.mask)) return Settled::mask;
    if (plan.filter) {
        const BodyId i = store.id(c.a), k = store.id(c.b);
        if (!(*plan.filter)(std::min(i, k), std::max(i, k))) return Settled::filter;
    }
    return Settled::no;
}

/// Whether the layer that would settle the pair is at work.
bool at_work(Settled by, Layers without)
{
    switch (by) {
    case Settled::immovable:
        return !without.has(Layer::immovable);
    case Settled::asleep:
        return !without.has(Layer::asleep);
    case Settled::mask:
        return !without.has(Layer::mask);
    case Settled::filter:
        return !without.has(Layer::filter);
    default:
        return false;
    }
}

} // namespace

void make_packet(Packet& p, const BlockTree& tree, std::uint32_t leaf, const Plan& plan)
{
    const std::size_t first = std::size_t{lanes} * leaf;
    p.boxes = tree.levels[0][leaf];
    p.held = tree.held(leaf);
    p.least = tree.least[0][leaf];
    p.groups = tree.groups[0].empty() ? Groups{} : tree.groups[0][leaf];
    p.far = 0;
    std::copy_n(tree.slots.begin() + static_cast<std::ptrdiff_t>(first), lanes, p.slots);
    if (plan.with_balls) p.balls = tree.balls[leaf];
    if (plan.rules.balls) {
        for (int lane = 0; lane < lanes; ++lane)
            p.far |= static_cast<Mask>(magnitude(p.balls, lane) > long_path * p.balls.radius[lane]) << lane;
        p.far &= p.held;
    }
    const bool cut = plan.rules.balls && plan.rules.late && plan.rules.until < 1;
    if (plan.grown > 0) grow(p.boxes, plan.rules.grown);
    if (cut) cut_off(p.boxes, p.balls, plan.rules.until, plan.rules.grown);
    const bool as_held = plan.grown == 0 && !cut;
    p.bound = as_held ? tree.bound_of_leaf(leaf) : bound_of(p.boxes);
    p.dense = p.far == 0 && fill(p.boxes, p.bound);
}

Packet packet_of(const Sweep& sweep, const Plan& plan)
{
    Packet p;
    for (int lane = 0; lane < lanes; ++lane) {
        put(p.boxes, lane, empty_box);
        put(p.balls, lane, {});
    }
    put(p.boxes, 0, sweep.box);
    put(p.balls, 0, sweep);
    p.held = 1;
    p.far = plan.rules.balls && magnitude(p.balls, 0) > long_path * sweep.radius ? 1 : 0;
    p.slots[0] = no_slot;
    p.groups = {plan.category, plan.mask};
    if (plan.grown > 0) grow(p.boxes, plan.rules.grown);
    p.bound = bound_of(p.boxes);
    return p;
}

void drop_what_need_not_be_asked(Chunk& chunk, const BodyStore& store, const Plan& plan)
{
    const bool meets_all = plan.category != 0 && plan.mask == 0xffffffff;
    if (store.picky == 0 && !plan.filter && !plan.rest_pairs && meets_all) return;
    Candidates& all = chunk.candidates;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.count; ++i) {
        const Candidate c = all[i];
        const Settled by = settled(c, store, plan);
        if (!at_work(by, plan.without)) {
            all.set(kept++, c);
            continue;
        }
        chunk.immovable += by == Settled::immovable ? 1 : 0;
        chunk.asleep += by == Settled::asleep ? 1 : 0;
        chunk.masked += by == Settled::mask ? 1 : 0;
        chunk.filtered += by == Settled::filter ? 1 : 0;
    }
    all.count = kept;
}

bool meets(const Candidate& c, const BodyStore& store, const Plan& plan)
{
    return settled(c, store, plan) == Settled::no;
}

} // namespace brink
