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
    Met(SceneData& data, const Cast& cast) : data_(data), cast_(cast), known_until_(cast.options.pair.t_max)
    {
        data_.impacts.clear();
    }

    /// Asks about a body, unless that is later than what is known or beyond the budget.
    void look(std::uint32_t slot, double t)
    {
        if (cast_.first && !data_.impacts.empty() && t > data_.impacts.front().toi.t) {
            ++asked_.late;
        } else if (asked_.exact == cast_.options.max_tests) {
            known_until_ = std::min(known_until_, t);
        } else {
            ++asked_.exact;
            keep(cast_.ask(data_.store, slot));
        }
    }
    double known_until() const { return known_until_; }
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
    double known_until_;
    Asked asked_;
};

/// A plane or half-space is asked against everything bounded.
void cast_unbounded(SceneData& data, const Cast& cast, Met& met)
{
    for (std::uint32_t slot = 0; slot < data.store.bodies.size(); ++slot) {
        const Body& b = data.store.bodies[slot];
        if (data.store.ids[slot] == no_body || unbounded(b.shape)) continue;
        if (!masks_meet(cast.options.category, cast.options.mask, b.category, b.mask)) continue;
        met.look(slot, 0);
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
    Met met(data, cast);
    if (unbounded(cast.shape)) {
        data.search.forget();
        cast_unbounded(data, cast, met);
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
    return met.known_until();
}

} // namespace

Impact Scene::cast(const Shape& shape, const Motion& motion, const SceneOptions& options)
{
    check(options);
    check_cast(shape, motion);
    const double known_until = cast_into(*data_, {shape, motion, options, true});
    const bool any = !data_->impacts.empty();
    Impact first;
    if (any) first = data_->impacts.front();
    if (any && first.toi.t <= known_until) return first;
    first = {};
    first.toi.t = known_until;
    first.toi.status = known_until < options.pair.t_max ? Status::undecided : Status::separated;
    return first;
}

Impacts Scene::cast_all(const Shape& shape, const Motion& motion, const SceneOptions& options)
{
    check(options);
    check_cast(shape, motion);
    const double known_until = cast_into(*data_, {shape, motion, options, false});
    return {in_order(*data_), known_until};
}

} // namespace brink
