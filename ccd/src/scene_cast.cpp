// SPDX-License-Identifier: BSD-3-Clause
// The questions about one shape or ray that is no body of the scene.
#include "placed_shape.h"
#include "scene_met.h"
#include "sweep.h"
#include "tolerance.h"
#include "unbounded.h"

#include <algorithm>
#include <cmath>

namespace brink {

namespace {

/// A shape that is cast, as the searches see it.
struct Cast {
    const Shape& shape;
    const Motion& motion;
    const SceneOptions& options;
    double t_max;

    Impact ask(const BodyStore& store, std::uint32_t slot) const
    {
        const Body& b = store.bodies[slot];
        return {no_body, store.id(slot), time_of_impact(shape, motion, b.shape, b.motion, options.pair)};
    }
    static bool met(const Impact& impact) { return in_contact(impact.toi); }
    static double begins(const Impact& impact) { return impact.toi.t; }
};

/// A plane or half-space is asked against everything bounded.
template <class Met> void cast_unbounded(SceneData& data, const Plan& plan, Met& met)
{
    const Timed deciding(data.search.decide_seconds);
    for (std::uint32_t slot = 0; slot < data.store.bodies.size(); ++slot) {
        const Body& b = data.store.bodies[slot];
        if (data.store.ids[slot] != no_body && !unbounded(b.shape)) look_unsearched(data, plan, slot, met);
    }
}

/// Tells of what a shape meets; returns a time before which it meets nothing that was not asked about.
template <class Tell> double cast(SceneData& data, const Asking& asking, const Cast& cast, Tell tell)
{
    Plan plan = asking.plan(cast.options);
    plan.category = cast.options.category;
    plan.mask = cast.options.mask;
    Packet packet;
    plan.alone = &packet;
    Met met(data.store, plan, cast, tell);
    if (unbounded(cast.shape)) {
        data.search.forget();
        plan.bounded_only = true;
        cast_unbounded(data, plan, met);
    } else {
        packet = packet_of(sweep({cast.shape, cast.motion}, data.broad.origin), plan);
        data.search.run(
            data.store, data.broad, plan, [](Chunk&) {},
            [&](Chunk& chunk) {
                for (const Candidate& c : by_time(chunk, chunk.candidates.count))
                    met.look(c.b, static_cast<double>(c.t));
                if (plan.rules.late) plan.rules.until = round_up(met.until());
                return met.until() >= 0;
            });
    }
    asking.write_ledger(plan, met.asked());
    return met.least_open();
}

Cast checked(const Shape& shape, const Motion& motion, const SceneOptions& options)
{
    check(options);
    check_cast(shape, motion);
    return {shape, motion, options, options.pair.t_max};
}

} // namespace

Impact Scene::cast(const Shape& shape, const Motion& motion, const SceneOptions& options)
{
    const Cast asked = checked(shape, motion, options);
    const Asking asking(*data_);
    std::vector<Impact>& found = data_->impacts;
    found.clear();
    const double open = brink::cast(*data_, asking, asked, keep_first(found, Cast::begins));
    if (!found.empty() && found.front().toi.t <= open) return found.front();
    Impact none;
    none.toi.t = std::min(open, options.pair.t_max);
    none.toi.status = open <= options.pair.t_max ? Status::undecided : Status::separated;
    return none;
}

Impacts Scene::cast_all(const Shape& shape, const Motion& motion, const SceneOptions& options)
{
    const Cast asked = checked(shape, motion, options);
    const Asking asking(*data_);
    data_->impacts.clear();
    const double open = brink::cast(*data_, asking, asked, keep_all(data_->impacts));
    return {in_order(*data_), std::min(open, options.pair.t_max), open == infinity};
}

double Scene::visit_cast(const Shape& shape, const Motion& motion, const Visitor& visitor,
                         const SceneOptions& options)
{
    const Cast asked = checked(shape, motion, options);
    check_visitor(visitor);
    const Asking asking(*data_);
    return brink::cast(*data_, asking, asked, std::cref(visitor));
}

} // namespace brink
