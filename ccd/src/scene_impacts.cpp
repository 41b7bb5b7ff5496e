// SPDX-License-Identifier: BSD-3-Clause
// The questions about all pairs: first impact, every impact.
#include "packet.h"
#include "scene_data.h"
#include "sweep.h"

#include <algorithm>

namespace brink {

namespace {

/// A time before which none of a chunk's other candidates is in contact.
double least_of_others(const Chunk& chunk, const SceneOptions& options)
{
    double least = infinity;
    for (std::size_t i = allowed(chunk, options); i < chunk.candidates.count; ++i)
        least = std::min(least, static_cast<double>(chunk.candidates.t[i]));
    return least;
}

/// Asks a chunk's candidates exactly and keeps what is in contact.
void ask_all(Chunk& chunk, const SceneData& data, const SceneOptions& options, const Plan& plan)
{
    chunk.impacts.clear();
    const std::size_t end = allowed(chunk, options);
    for (std::size_t i = 0; i < end; ++i) {
        const Candidate c = chunk.candidates[i];
        const Impact impact = ask(data.store, c.a, c.b, options.pair);
        if (in_contact(impact.toi) && (plan.without.bits == 0 || meets(c, data.store, plan)))
            chunk.impacts.push_back(impact);
    }
}

/// The least time of what nobody asked about, and whether there is anything more to learn.
class Unasked {
public:
    explicit Unasked(const SceneOptions& options) : options_(options) {}
    /// Infinite where nothing is left.
    double least() const { return least_; }
    bool take(const Chunk& chunk, Plan& plan)
    {
        exact_ += allowed(chunk, options_);
        least_ = std::min(least_, least_of_others(chunk, options_));
        if (plan.rules.late && least_ < options_.pair.t_max) plan.rules.until = round_up(least_);
        return least_ > 0;
    }
    std::uint64_t exact() const { return exact_; }

private:
    const SceneOptions& options_;
    double least_ = infinity;
    std::uint64_t exact_ = 0;
};

/// The earliest impact so far, and how it narrows the search.
class Earliest {
public:
    Earliest(const SceneData& data, const SceneOptions& options) : data_(data), options_(options) {}

    /// Whether a candidate may yet be earlier.
    bool matters(const Candidate& c, const Impact& than) const
    {
        if (than.a == no_body && than.b == no_body) return true;
        const auto t = static_cast<double>(c.t);
        if (t != than.toi.t) return t < than.toi.t;
        const BodyId a = data_.store.id(c.a), b = data_.store.id(c.b);
        return earlier({std::min(a, b), std::max(a, b), than.toi}, than);
    }

    /// Asks those of a chunk's candidates that matter, the earliest first, and keeps the first.
    void decide(Chunk& chunk, const Options& time_only, const Plan& plan) const
    {
        Impact best = best_;
        chunk.impacts.clear();
        chunk.asked = 0;
        for (const Candidate& c : by_time(chunk, allowed(chunk, options_))) {
            if (plan.rules.late && !matters(c, best)) continue;
            const Impact impact = ask(data_.store, c.a, c.b, time_only);
            ++chunk.asked;
            if (!in_contact(impact.toi) || (found(best) && !earlier(impact, best))) continue;
            if (plan.without.bits == 0 || meets(c, data_.store, plan)) best = impact;
        }
        if (found(best)) chunk.impacts.push_back(best);
    }

    void take(const Chunk& chunk, Plan& plan)
    {
        asked_.exact += chunk.asked;
        asked_.late += allowed(chunk, options_) - chunk.asked;
        for (const Impact& impact : chunk.impacts)
            if (!found(best_) || earlier(impact, best_)) best_ = impact;
        if (!found(best_) || !plan.rules.late) return;
        plan.rules.until = std::min(plan.rules.until, round_up(best_.toi.t));
        if (best_.toi.t == 0) plan.rules.below = best_.a;
    }

    static bool found(const Impact& impact) { return impact.b != no_body; }
    const Impact& best() const { return best_; }
    const Asked& asked() const { return asked_; }

private:
    const SceneData& data_;
    const SceneOptions& options_;
    Impact best_;
    Asked asked_;
};

Impact none(Status status, double t)
{
    Impact impact;
    impact.toi.status = status;
    impact.toi.t = t;
    return impact;
}

} // namespace

Impact Scene::first_impact(const SceneOptions& options)
{
    check(options);
    SceneData& data = *data_;
    const Asking asking(data);
    Plan plan = asking.plan(options);
    plan.scattered = true;
    Options time_only = options.pair;
    time_only.detail = Detail::time_only;

    Earliest earliest(data, options);
    double unasked = infinity;
    data.search.run(
        data.store, data.broad, plan, [&](Chunk& chunk) { earliest.decide(chunk, time_only, plan); },
        [&](const Chunk& chunk) {
            earliest.take(chunk, plan);
            unasked = std::min(unasked, least_of_others(chunk, options));
            return unasked > 0;
        });
    asking.write_ledger(plan, earliest.asked());

    const Impact& best = earliest.best();
    const double t_max = options.pair.t_max;
    if (Earliest::found(best) ? unasked < best.toi.t : unasked <= t_max)
        return none(Status::undecided, unasked);
    if (!Earliest::found(best)) return none(Status::separated, t_max);
    if (options.pair.detail == Detail::time_only) return best;
    const Timed deciding(data.ledger.exact_seconds);
    return ask(data.store, data.store.slot_of(best.a), data.store.slot_of(best.b), options.pair);
}

std::span<const Impact> in_order(SceneData& data)
{
    const Timed ordering(data.ledger.order_seconds);
    data.keys.clear();
    for (const Impact& i : data.impacts)
        data.keys.push_back({i.toi.t, i.a, i.b, static_cast<std::uint32_t>(data.keys.size())});
    std::sort(data.keys.begin(), data.keys.end(), [](const SceneData::Key& x, const SceneData::Key& y) {
        if (x.t != y.t) return x.t < y.t;
        return x.a != y.a ? x.a < y.a : x.b < y.b;
    });
    data.ordered.clear();
    for (const SceneData::Key& key : data.keys)
        data.ordered.push_back(data.impacts[key.at]);
    return data.ordered;
}

Impacts Scene::impacts(const SceneOptions& options)
{
    check(options);
    SceneData& data = *data_;
    const Asking asking(data);
    Plan plan = asking.plan(options);
    data.impacts.clear();
    Unasked unasked(options);
    data.search.run(
        data.store, data.broad, plan, [&](Chunk& chunk) { ask_all(chunk, data, options, plan); },
        [&](const Chunk& chunk) {
            data.impacts.insert(data.impacts.end(), chunk.impacts.begin(), chunk.impacts.end());
            return unasked.take(chunk, plan);
        });
    asking.write_ledger(plan, {unasked.exact(), 0});
    return {in_order(data), std::min(unasked.least(), options.pair.t_max), unasked.least() == infinity};
}

double Scene::visit_impacts(const Visitor& visitor, const SceneOptions& options)
{
    check(options);
    check_visitor(visitor);
    SceneData& data = *data_;
    const Asking asking(data);
    Plan plan = asking.plan(options);
    double until = options.pair.t_max;
    Unasked unasked(options);
    data.search.run(
        data.store, data.broad, plan, [&](Chunk& chunk) { ask_all(chunk, data, options, plan); },
        [&](const Chunk& chunk) {
            for (const Impact& impact : chunk.impacts) {
                if (impact.toi.t > until) continue;
                until = narrowed(until, visitor(impact));
                if (until < 0) return false;
            }
            const bool more = unasked.take(chunk, plan);
            if (plan.rules.late) plan.rules.until = std::min(plan.rules.until, round_up(until));
            return more;
        });
    asking.write_ledger(plan, {unasked.exact(), 0});
    return unasked.least();
}

} // namespace brink
