// SPDX-License-Identifier: BSD-3-Clause
#include "best_step.h"

#include "support.h"

#include <algorithm>
#include <type_traits>

namespace brink {

template <class Part> Step first_step(const Facing<Part>& f, const Sight& sight, double horizon)
{
    if constexpr (std::is_same_v<Part, Core>) {
        const double gap = gap_along(f.a.part, f.b.part, sight.normal) - f.margin;
        const double rate = closing_rate(f, sight.normal);
        if (gap > 0 && rate * horizon <= gap) return {gap, horizon, 0};
        const Step rest = safe_step(f, TurningAxis{sight.normal, {}}, horizon);
        if (rest.length > 0) return rest;
    }
    return best_step(f, sight, {}, horizon);
}

template <class Part> Step best_step(const Facing<Part>& f, const Sight& sight, V3 rolling, double horizon)
{
    Step best;
    const auto attempt = [&](const TurningAxis& axis) {
        const Step s = safe_step(f, axis, horizon);
        if (s.length > best.length || (best.length == 0 && s.gap > best.gap)) best = s;
    };
    if (!(sight.axis.normal == V3{})) attempt(sight.axis);
    if constexpr (std::is_same_v<Part, Core>) {
        if (sight.normal == V3{} || best.length >= horizon) return best;
        if (!(rolling == V3{})) attempt(TurningAxis{sight.normal, rolling});
        // Worse than the first order: the features mislead.
        if (!sight.guessed && best.length * closing_rate(f, sight.normal) >= best.gap && best.length > 0)
            return best;
        attempt(TurningAxis{sight.normal, {}});
        if (!sight.guessed) return best;
        attempt(TurningAxis{sight.normal, f.a.rate});
        attempt(TurningAxis{sight.normal, f.b.rate});
    }
    return best;
}

template <class Part> double step_at_hand(const Facing<Part>& f, V3 normal, double horizon)
{
    if constexpr (std::is_same_v<Part, Border>) {
        return 0; // the plane's normal is all there is
    } else {
        double best = safe_step(f, TurningAxis{normal, {}}, horizon).length;
        const V3 across = middle(f.b.part) - middle(f.a.part);
        const double apart = norm(across);
        if (apart > 0)
            best = std::max(best, safe_step(f, TurningAxis{(1 / apart) * across, {}}, horizon).length);
        return best;
    }
}

template Step first_step(const Facing<Core>&, const Sight&, double);
template Step first_step(const Facing<Border>&, const Sight&, double);
template Step best_step(const Facing<Core>&, const Sight&, V3, double);
template Step best_step(const Facing<Border>&, const Sight&, V3, double);
template double step_at_hand(const Facing<Core>&, V3, double);
template double step_at_hand(const Facing<Border>&, V3, double);

} // namespace brink
