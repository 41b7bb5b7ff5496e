// SPDX-License-Identifier: BSD-3-Clause
#include "best_step.h"

#include "corner_step.h"
#include "stride.h"
#include "support.h"
#include "tolerance.h"

#include <algorithm>
#include <type_traits>

namespace brink {

bool passes(const Facing<Core>& f, const Sight& sight, double horizon)
{
    const bool known = sight.apart > -infinity;
    const double gap = (known ? sight.apart : gap_along(f.a.part, f.b.part, sight.normal)) - f.margin;
    return gap > 0 && closing_rate(f, sight.normal) * horizon <= gap;
}
bool passes(const Facing<Border>&, const Sight&, double) { return false; }

template <class Part> Step first_step(const Facing<Part>& f, const Sight& sight, double horizon)
{
    if constexpr (std::is_same_v<Part, Core>) {
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

bool Trail::lost(const Step& step, const Facing<Core>& f, Watch& watch, Sight& sight, double radii)
{
    if (followed == 0) return false;
    const bool slow = !(step.gap > 0) || step.gap > tolerance::slow_step * last_gap;
    if (slow || followed > tolerance::most_followed) return true;
    if (!(step.gap < tolerance::worth_landing * seen_gap)) return false;
    seen_gap = step.gap;
    watch.land(f, sight);
    return step.gap < tolerance::stale_features * (sight.upper - radii);
}

bool Trail::lost(const Step&, const Facing<Border>&, const BorderWatch&, const Sight&, double) const
{
    return followed > tolerance::most_followed;
}

namespace {

V3 gone_along(V3 normal, const Posed<Core>& body, double time)
{
    if (!(body.angle > 0)) return normal;
    return turned(Turn{body.rate, (1 / body.angle) * body.rate, body.angle}, time) * normal;
}

} // namespace

template <class Part>
AtHand step_at_hand(const Facing<Part>& f, const AtHand& served, const TurningAxis& followed, double horizon)
{
    AtHand best{followed.normal, corner_step(f, followed, horizon).length};
    if constexpr (std::is_same_v<Part, Core>) { // a plane's normal is all there is
        const auto attempt = [&](V3 n, V3 spin) {
            const double length = safe_step(f, TurningAxis{n, spin}, horizon).length;
            if (length > best.length) best = {n, length};
        };
        attempt(served.normal, {});
        attempt(gone_along(served.normal, f.a, served.length), f.a.rate);
        attempt(gone_along(served.normal, f.b, served.length), f.b.rate);
        const V3 across = middle(f.b.part) - middle(f.a.part);
        if (norm(across) > 0) attempt((1 / norm(across)) * across, {});
        const Stride tilted = stride(f, best.normal, horizon);
        if (tilted.step.length > best.length) best = {tilted.axis.normal, tilted.step.length};
    }
    return best;
}

template Step first_step(const Facing<Core>&, const Sight&, double);
template Step first_step(const Facing<Border>&, const Sight&, double);
template Step best_step(const Facing<Core>&, const Sight&, V3, double);
template Step best_step(const Facing<Border>&, const Sight&, V3, double);
template AtHand step_at_hand(const Facing<Core>&, const AtHand&, const TurningAxis&, double);
template AtHand step_at_hand(const Facing<Border>&, const AtHand&, const TurningAxis&, double);

} // namespace brink
