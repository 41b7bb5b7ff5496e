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
    const BodyId a = store.ids[c.a], b = store.ids[c.b];
    const BodyId swap = (a ^ b) & (0U - static_cast<BodyId>(b < a)); // a branch would be guessed wrong
    return {a ^ swap, b ^ swap};
}

} // namespace

std::span<const BodyPair> Scene::overlapping(const SceneOptions& options)
{
    check(options);
    SceneData& data = *data_;
    const Asking asking(data);
    Plan plan = asking.plan(options);
    plan.grown = 0;
    plan.rules.grown = 0;
    if (plan.rules.late) plan.rules.until = 0;
    std::uint64_t exact = 0;
    data.pairs.clear();
    data.search.run(
        data.store, data.broad, plan,
        [&](Chunk& chunk) {
            Candidates& all = chunk.candidates;
            chunk.asked = all.count;
            std::size_t kept = 0;
            for (std::size_t i = 0; i < all.count; ++i) {
                const Candidate c = all[i];
                const bool in_order = data.store.ids[c.a] < data.store.ids[c.b];
                const Body &a = data.store.bodies[in_order ? c.a : c.b],
                           &b = data.store.bodies[in_order ? c.b : c.a];
                if (!overlaps(a.shape, a.motion.start, b.shape, b.motion.start)) continue;
                if (plan.without.bits == 0 || meets(c, data.store, plan)) all.set(kept++, c);
            }
            all.count = kept;
        },
        [&](const Chunk& chunk) {
            exact += chunk.asked;
            for (std::size_t i = 0; i < chunk.candidates.count; ++i)
                data.pairs.push_back(pair_of(data.store, chunk.candidates[i]));
            return true;
        });
    asking.write_ledger(plan, {exact, 0});
    std::sort(data.pairs.begin(), data.pairs.end(),
              [](BodyPair x, BodyPair y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
    return data.pairs;
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
