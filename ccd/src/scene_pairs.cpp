// SPDX-License-Identifier: BSD-3-Clause
// The questions about pairs that need no time of impact.
#include "packet.h"
#include "scene_data.h"

#include <brink/overlap.h>

#include <algorithm>

namespace brink {

namespace {

BodyPair pair_of(const BodyStore& store, const Candidate& c)
{
    const BodyId a = store.id(c.a), b = store.id(c.b);
    const BodyId swap = (a ^ b) & (0U - static_cast<BodyId>(b < a)); // a branch would be guessed wrong
    return {a ^ swap, b ^ swap};
}

/// Leaves in a chunk those of its candidates that overlap.
void keep_overlapping(Chunk& chunk, const BodyStore& store, const SceneOptions& options, const Plan& plan)
{
    Candidates& all = chunk.candidates;
    chunk.asked = allowed(chunk, options);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < chunk.asked; ++i) {
        const Candidate c = all[i];
        const bool in_order = store.id(c.a) < store.id(c.b);
        const Body &a = store.bodies[in_order ? c.a : c.b], &b = store.bodies[in_order ? c.b : c.a];
        if (!overlaps(a.shape, a.motion.start, b.shape, b.motion.start)) continue;
        if (plan.without.bits == 0 || meets(c, store, plan)) all.set(kept++, c);
    }
    chunk.left = all.count - chunk.asked;
    all.count = kept;
}

/// Tells of the pairs that overlap at the start until it returns a negative number; returns 0 where some
/// were left undecided, infinity where none was.
template <class Tell>
double find_overlapping(SceneData& data, const Asking& asking, const SceneOptions& options, Tell tell)
{
    Plan plan = asking.plan(options);
    plan.grown = 0;
    plan.rules.grown = 0;
    if (plan.rules.late) plan.rules.until = 0;
    std::uint64_t exact = 0;
    double open = infinity;
    data.search.run(
        data.store, data.broad, plan,
        [&](Chunk& chunk) { keep_overlapping(chunk, data.store, options, plan); },
        [&](const Chunk& chunk) {
            exact += chunk.asked;
            for (std::size_t i = 0; i < chunk.candidates.count; ++i)
                if (narrowed(0, tell(pair_of(data.store, chunk.candidates[i]))) < 0) return false;
            if (chunk.left > 0) open = 0;
            return open > 0;
        });
    asking.write_ledger(plan, {exact, 0});
    return open;
}

} // namespace

Overlaps Scene::overlapping(const SceneOptions& options)
{
    check(options);
    const Asking asking(*data_);
    std::vector<BodyPair>& found = data_->pairs;
    found.clear();
    const double open = find_overlapping(*data_, asking, options, [&](BodyPair pair) {
        found.push_back(pair);
        return infinity;
    });
    const Timed ordering(data_->ledger.order_seconds);
    std::sort(found.begin(), found.end(),
              [](BodyPair x, BodyPair y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
    return {found, open == infinity};
}

double Scene::visit_overlapping(const VisitorOf<BodyPair>& visitor, const SceneOptions& options)
{
    check(options);
    check_visitor(visitor);
    const Asking asking(*data_);
    return find_overlapping(*data_, asking, options, std::cref(visitor));
}

std::span<const BodyPair> Scene::candidates(Bounds bounds)
{
    SceneData& data = *data_;
    const Asking asking(data);
    Plan plan = asking.plan({});
    plan.grown = 0;
    plan.rules.grown = 0;
    plan.rules.balls = bounds == Bounds::balls;
    plan.rules.times = false;
    std::size_t count = 0;
    data.search.run(
        data.store, data.broad, plan,
        [&](std::size_t so_far) {
            if (data.pairs.size() < so_far) data.pairs.resize(so_far);
        },
        [&](const Chunk& chunk) {
            for (std::size_t i = 0; i < chunk.candidates.count; ++i)
                data.pairs[chunk.before + i] = pair_of(data.store, chunk.candidates[i]);
        },
        [&](const Chunk& chunk) {
            count += chunk.candidates.count;
            return true;
        });
    asking.write_ledger(plan, {});
    return {data.pairs.data(), count};
}

} // namespace brink
