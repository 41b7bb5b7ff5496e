// SPDX-License-Identifier: BSD-3-Clause
#include <brink/scene.h>

#include "scene_data.h"
#include "sweep.h"
#include "tolerance.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <utility>

namespace brink {

namespace {

void refuse_while_asked(const SceneData& data)
{
    if (data.busy)
        throw std::logic_error("brink::Scene: changed or asked from within one of its own queries");
}

/// That all are there and none is named twice. Returns how many are not among the movers.
std::size_t check_named(const BodyStore& store, BroadPhase& broad, std::span<const BodyId> bodies)
{
    std::size_t others = 0, named = 0;
    const auto forget = [&] {
        for (const BodyId id : bodies.first(named))
            broad.forget_name(store.slot_of(id));
    };
    for (const BodyId id : bodies) {
        if (!store.contains(id) || !broad.name(store.slot_of(id))) break;
        others += broad.is_mover(store.slot_of(id)) ? 0 : 1;
        ++named;
    }
    forget();
    if (named == bodies.size()) return others;
    store.slot(bodies[named]); // throws where there is no such body
    throw std::invalid_argument("brink::Scene: set_motions names body " + std::to_string(bodies[named]) +
                                " twice");
}

void check_motions(const BodyStore& store, std::span<const BodyId> bodies, std::span<const Motion> motions)
{
    std::atomic<std::size_t> bad = bodies.size(); // the first of them
    for_each_part(bodies.size(), [&](std::size_t i) {
        if (i + BodyStore::ahead < bodies.size()) store.fetch(store.slot_of(bodies[i + BodyStore::ahead]));
        if (fits(motions[i], store.bodies[store.slot_of(bodies[i])])) return;
        std::size_t first = bad.load();
        while (i < first && !bad.compare_exchange_weak(first, i)) {
        }
    });
    if (bad == bodies.size()) return;
    check(motions[bad], store.bodies[store.slot_of(bodies[bad])], bodies[bad]);
}

} // namespace

Scene::Scene() : data_(std::make_unique<SceneData>()) {}
Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

BodyId Scene::add(const Body& body)
{
    refuse_while_asked(*data_);
    check(body, data_->store.next_id());
    data_->broad.make_room(data_->store.bodies.size() + 1); // first: where there is none nothing changes
    const std::uint32_t slot = data_->store.add(body);
    data_->broad.add(slot, data_->store);
    return data_->store.ids[slot];
}

void Scene::replace(BodyId id, const Body& body)
{
    refuse_while_asked(*data_);
    const std::uint32_t slot = data_->store.slot(id);
    check(body, id);
    data_->broad.make_room(data_->store.bodies.size());
    data_->broad.remove(slot);
    data_->store.replace(slot, body);
    data_->broad.add(slot, data_->store);
}

void Scene::remove(BodyId id)
{
    refuse_while_asked(*data_);
    const std::uint32_t slot = data_->store.slot(id);
    data_->broad.remove(slot);
    data_->store.remove(slot);
}

void Scene::set_motion(BodyId id, const Motion& motion) { set_motions({&id, 1}, {&motion, 1}); }

void Scene::set_motions(std::span<const BodyId> bodies, std::span<const Motion> motions)
{
    refuse_while_asked(*data_);
    if (bodies.size() != motions.size())
        throw std::invalid_argument("brink::Scene: " + std::to_string(bodies.size()) + " bodies and " +
                                    std::to_string(motions.size()) +
                                    " motions: set_motions takes one for each");
    BodyStore& store = data_->store;
    BroadPhase& broad = data_->broad;
    const std::size_t at_rest = check_named(store, broad, bodies);
    check_motions(store, bodies, motions);
    if (at_rest > 0)
        broad.make_room_to_rest(static_cast<std::size_t>(std::count_if(
            bodies.begin(), bodies.end(), [&](BodyId id) { return broad.is_resting(store.slot_of(id)); })));
    for_each_part(bodies.size(), [&](std::size_t i) {
        if (i + BodyStore::ahead < bodies.size()) store.fetch(store.slot_of(bodies[i + BodyStore::ahead]));
        const std::uint32_t slot = store.slot_of(bodies[i]);
        store.bodies[slot].motion = motions[i];
        if (broad.is_mover(slot)) broad.moved(slot, store);
    });
    for (std::size_t i = 0; at_rest > 0 && i < bodies.size(); ++i)
        if (const std::uint32_t slot = store.slot_of(bodies[i]); !broad.is_mover(slot))
            broad.moved(slot, store);
    broad.refit_later();
}

void Scene::sleep(BodyId id)
{
    Body body = this->body(id);
    body.asleep = true;
    body.motion.translation = body.motion.rotation = {0, 0, 0};
    replace(id, body);
}

void Scene::wake(BodyId id)
{
    Body body = this->body(id);
    body.asleep = false;
    replace(id, body);
}

void Scene::set_filter(PairFilter filter)
{
    refuse_while_asked(*data_);
    data_->filter = std::move(filter);
}

std::size_t Scene::size() const { return data_->store.count(); }
bool Scene::contains(BodyId id) const { return data_->store.contains(id); }
const Body& Scene::body(BodyId id) const { return data_->store.bodies[data_->store.slot(id)]; }

Aabb Scene::swept_bounds(BodyId id)
{
    const std::uint32_t slot = data_->store.slot(id);
    update();
    const Box3f box = data_->broad.box(slot);
    const V3 o = data_->broad.origin;
    const auto corner = [&](const float(&c)[3], double outwards) {
        const auto moved = [outwards](double by, float x) {
            const double sum = by + static_cast<double>(x);
            return by == 0 ? sum : sum + outwards * std::fabs(sum);
        };
        return Vec3{moved(o.x, c[0]), moved(o.y, c[1]), moved(o.z, c[2])};
    };
    constexpr double place = 2 * tolerance::unit_roundoff;
    return {corner(box.min, -place), corner(box.max, place)};
}

void Scene::update()
{
    refuse_while_asked(*data_);
    data_->broad.update(data_->store);
}

const Ledger& Scene::ledger() const { return data_->ledger; }
std::size_t Scene::broad_phase_bytes() const
{
    return data_->broad.bytes() + data_->store.slots.capacity() * sizeof(std::uint32_t);
}

Asking::Asking(SceneData& data) : data_(data)
{
    refuse_while_asked(data);
    data.ledger = {};
    {
        const Timed updating(data.ledger.update_seconds);
        data.broad.update(data.store);
    }
    data.busy = true;
}

Plan Asking::plan(const SceneOptions& options) const
{
    const Layers off = options.without;
    Plan plan;
    plan.rules.boxes = !off.has(Layer::bounds);
    plan.rules.receding = !off.has(Layer::receding);
    plan.rules.spheres = !off.has(Layer::spheres);
    plan.rules.late = !off.has(Layer::late);
    plan.rules.groups = !off.has(Layer::mask);
    plan.rules.balls = plan.rules.receding || plan.rules.spheres || plan.rules.late;
    plan.wide = !off.has(Layer::simd);
    plan.without = off;
    plan.rest_pairs = off.has(Layer::immovable) || off.has(Layer::asleep);
    plan.grown = options.pair.target_gap + options.pair.tolerance;
    plan.rules.grown = round_up(plan.grown * tolerance::float_sums);
    plan.rules.until = plan.rules.late ? round_up(options.pair.t_max) : 1;
    if (data_.filter) plan.filter = &data_.filter;
    return plan;
}

namespace {

std::uint64_t pairs_of(std::uint64_t n) { return n > 0 ? n * (n - 1) / 2 : 0; }

struct Census {
    std::uint64_t all = 0, immovable = 0, resting = 0;
};

/// Pairs that are asked of at all, leaving out two unbounded ones.
Census pairs_in(const BodyStore& store, const BroadPhase& broad)
{
    Census unbounded;
    for (const std::uint32_t slot : broad.unbounded) {
        const Body& b = store.bodies[slot];
        ++unbounded.all;
        unbounded.immovable += b.immovable ? 1 : 0;
        unbounded.resting += at_rest(b) ? 1 : 0;
    }
    return {pairs_of(store.count()) - pairs_of(unbounded.all),
            pairs_of(store.immovable) - pairs_of(unbounded.immovable),
            pairs_of(store.immovable + store.asleep) - pairs_of(unbounded.resting)};
}

} // namespace

void Asking::write_ledger(const Plan& plan, const Asked& asked) const
{
    const Search& s = data_.search;
    Ledger& l = data_.ledger;
    const auto layer = [&](Layer by) -> std::uint64_t& { return l.removed[static_cast<unsigned>(by)]; };
    const Census census = pairs_in(data_.store, data_.broad);
    const std::size_t alone = data_.store.count() - (plan.bounded_only ? data_.broad.unbounded.size() : 0);
    l.pairs = plan.alone ? alone : census.all;
    const bool by_census = !plan.alone && !plan.rest_pairs;
    layer(Layer::immovable) = by_census ? census.immovable : s.immovable;
    layer(Layer::asleep) = by_census ? census.resting - census.immovable : s.asleep;
    const std::uint64_t elsewhere = s.counts.met + (by_census ? census.resting : 0);
    if (s.complete) layer(Layer::bounds) = l.pairs - elsewhere;
    layer(Layer::receding) = s.counts.receding;
    layer(Layer::spheres) = s.counts.spheres;
    layer(Layer::mask) = s.masked;
    layer(Layer::filter) = s.filtered;
    l.exact = asked.exact;
    layer(Layer::late) = s.counts.late + asked.late;
    std::uint64_t known = asked.exact;
    for (const std::uint64_t removed : l.removed)
        known += removed;
    l.left = l.pairs - known;
    l.search_seconds = s.search_seconds;
    l.exact_seconds = s.decide_seconds;
}

Impact ask(const BodyStore& store, std::uint32_t slot_a, std::uint32_t slot_b, const Options& options)
{
    if (store.id(slot_b) < store.id(slot_a)) std::swap(slot_a, slot_b);
    const Body &a = store.bodies[slot_a], &b = store.bodies[slot_b];
    return {store.id(slot_a), store.id(slot_b),
            time_of_impact(a.shape, a.motion, b.shape, b.motion, options)};
}

} // namespace brink
