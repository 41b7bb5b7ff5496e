// SPDX-License-Identifier: BSD-3-Clause
// The questions when bodies have to halt.
#include "scene_halts.h"

#include <functional>

namespace brink {

std::span<const SafeTime> Scene::safe_times(const SceneOptions& options)
{
    check(options);
    SceneData& data = *data_;
    const Asking asking(data);
    Halts(data, options, asking).let_all_halt([](const SafeTime&) { return infinity; });
    const Timed ordering(data.ledger.order_seconds);
    const BodyStore& store = data.store;
    data.safe_times.clear();
    for (std::uint32_t slot = 0; slot < store.bodies.size(); ++slot)
        if (store.ids[slot] != no_body)
            data.safe_times.push_back({store.ids[slot], std::min(data.halted[slot], options.pair.t_max)});
    if (store.reused)
        std::sort(data.safe_times.begin(), data.safe_times.end(),
                  [](const SafeTime& x, const SafeTime& y) { return x.body < y.body; });
    return data.safe_times;
}

void Scene::visit_safe_times(const VisitorOf<SafeTime>& visitor, const SceneOptions& options)
{
    check(options);
    check_visitor(visitor);
    const Asking asking(*data_);
    Halts(*data_, options, asking).let_all_halt(std::cref(visitor));
}

} // namespace brink
