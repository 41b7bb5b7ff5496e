// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "packet.h"
#include "scene_data.h"

#include <algorithm>

namespace brink {

/// What one shape or ray meets on its way through a scene, told of one by one until whoever listens has heard
/// enough or the budget is spent.
///
/// Query: `options`, `t_max`, `ask(store, slot)` for a result, whether that is `met` and when it `begins`.
template <class Query, class Tell> class Met {
public:
    Met(const BodyStore& store, const Plan& plan, const Query& query, Tell tell)
        : store_(store), plan_(plan), query_(query), tell_(tell), until_(query.t_max)
    {
    }

    /// Asks about a body that is not met before t, unless that is too late or beyond the budget.
    void look(std::uint32_t slot, double t)
    {
        if (t > until_) {
            ++asked_.late;
        } else if (asked_.exact == query_.options.max_tests) {
            least_open_ = std::min(least_open_, t);
        } else {
            ++asked_.exact;
            const auto result = query_.ask(store_, slot);
            if (!query_.met(result) || query_.begins(result) > until_) return;
            if (plan_.without.bits == 0 || meets({no_slot, slot, 0}, store_, plan_))
                until_ = narrowed(until_, tell_(result));
        }
    }
    /// Nothing is met before this that was not asked about; infinite where all was asked.
    double least_open() const { return least_open_; }
    /// What begins later does not matter any more; negative when nothing does.
    double until() const { return until_; }
    const Asked& asked() const { return asked_; }

private:
    const BodyStore& store_;
    const Plan& plan_;
    const Query& query_;
    Tell tell_;
    double until_, least_open_ = infinity;
    Asked asked_;
};

/// Asks about a body that no tree could search for.
template <class Met> void look_unsearched(SceneData& data, const Plan& plan, std::uint32_t slot, Met& met)
{
    ++data.search.counts.met;
    if (plan.without.has(Layer::mask) || meets({no_slot, slot, 0}, data.store, plan))
        met.look(slot, 0);
    else
        ++data.search.masked;
}

/// Keeps the earliest result and wants to hear of none that is later.
template <class Result, class Begins> auto keep_first(std::vector<Result>& found, Begins begins)
{
    return [&found, begins](const Result& result) {
        if (found.empty())
            found.push_back(result);
        else if (earlier(result, found.front()))
            found.front() = result;
        return begins(found.front());
    };
}

/// Keeps all.
template <class Result> auto keep_all(std::vector<Result>& found)
{
    return [&found](const Result& result) {
        found.push_back(result);
        return infinity;
    };
}

} // namespace brink
