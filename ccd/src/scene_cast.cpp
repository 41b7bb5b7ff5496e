// SPDX-License-Identifier: BSD-3-Clause
// The questions about one shape or ray that is no body of the scene.
#include "packet.h"
#include "placed_shape.h"
#include "scene_data.h"
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
    bool first = false; // only the earliest is asked for

    Impact ask(const BodyStore& store, std::uint32_t slot) const
    {
        const Body& b = store.bodies[slot];
        return {no_body, store.ids[slot], time_of_impact(shape, motion, b.shape, b.motion, options.pair)};
    }
};

/// What a cast has met so far.
class Met {
public:
    Met(SceneData& data, const Cast& cast, const Plan& plan) : data_(data), cast_(cast), plan_(plan)
    {
        data_.impacts.clear();
    }

    /// Asks about a body, unless that is later than what is known or beyond the budget.
    void look(std::uint32_t slot, double t)
    {
        if (cast_.first && !data_.impacts.empty() && t > data_.impacts.front().toi.t) {
            ++asked_.late;
        } else if (asked_.exact == cast_.options.max_tests) {
            least_open_ = std::min(least_open_, t);
        } else {
            ++asked_.exact;
            const Impact impact = cast_.ask(data_.store, slot);
            if (plan_.without.bits == 0 || meets({no_slot, slot, 0}, data_.store, plan_)) keep(impact);
        }
    }
    /// A time before which nothing is met that was not asked about; infinite where all was asked.
    double least_open() const { return least_open_; }
    const Asked& asked() const { return asked_; }
    /// A time after which nothing matters any more.
    double until() const
    {
        const bool known = cast_.first && !data_.impacts.empty();
        return known ? data_.impacts.front().toi.t : cast_.options.pair.t_max;
    }

private:
    void keep(const Impact& impact)
    {
        if (!in_contact(impact.toi)) return;
        if (!cast_.first || data_.impacts.empty())
            data_.impacts.push_back(impact);
        else if (earlier(impact, data_.impacts.front()))
            data_.impacts.front() = impact;
    }

    SceneData& data_;
    const Cast& cast_;
    const Plan& plan_;
    double least_open_ = infinity;
    Asked asked_;
};

/// A plane or half-space is asked against everything bounded.
void cast_unbounded(SceneData& data, const Plan& plan, Met& met)
{
    for (std::uint32_t slot = 0; slot < data.store.bodies.size(); ++slot) {
        const Body& b = data.store.bodies[slot];
        if (data.store.ids[slot] == no_body || unbounded(b.shape)) continue;
        ++data.search.counts.met;
        if (plan.without.has(Layer::mask) || meets({no_slot, slot, 0}, data.store, plan))
            met.look(slot, 0);
        else
            ++data.search.masked;
    }
}

double cast_into(SceneData& data, const Cast& cast)
{
    const Asking asking(data);
    Plan plan = asking.plan(cast.options);
    plan.category = cast.options.category;
    plan.mask = cast.options.mask;
    Packet packet;
    plan.alone = &packet;
    Met met(data, cast, plan);
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
                return true;
            });
    }
    asking.write_ledger(plan, met.asked());
    return met.least_open();
}

} // namespace

Impact Scene::cast(const Shape& shape, const Motion& motion, const SceneOptions& options)
{
    check(options);
    check_cast(shape, motion);
    const double open = cast_into(*data_, {shape, motion, options, true});
    if (!data_->impacts.empty() && data_->impacts.front().toi.t <= open) return data_->impacts.front();
    Impact none;
    none.toi.t = std::min(open, options.pair.t_max);
    none.toi.status = open <= options.pair.t_max ? Status::undecided : Status::separated;
    return none;
}

Impacts Scene::cast_all(const Shape& shape, const Motion& motion, const SceneOptions& options)
{
    check(options);
    check_cast(shape, motion);
    const double open = cast_into(*data_, {shape, motion, options, false});
    return {in_order(*data_), std::min(open, options.pair.t_max), open == infinity};
}

} // namespace brink
