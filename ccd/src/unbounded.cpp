// SPDX-License-Identifier: BSD-3-Clause
#include "unbounded.h"

#include "core.h"
#include "mover.h"
#include "tolerance.h"

#include <cmath>
#include <optional>

namespace brink {

namespace {

/// A border that stands still, seen from the scene's origin, and the sum of the lengths that entered it.
struct Standing {
    Border border;
    double lengths;
};

std::optional<Standing> standing_border(const Body& body, V3 origin)
{
    const Motion& m = body.motion;
    if (!(load(m.rotation) == V3{} && load(m.translation) == V3{})) return std::nullopt;
    const V3 from = load(m.start.position) - origin;
    const auto place = [&](const auto& shape) {
        return Standing{placed(part(shape), rotation(m.start.orientation), from),
                        std::fabs(shape.offset) + sum_of_magnitudes(from)};
    };
    if (const auto* plane = std::get_if<Plane>(&body.shape)) return place(*plane);
    if (const auto* half = std::get_if<HalfSpace>(&body.shape)) return place(*half);
    return std::nullopt;
}

V3 at(const float (&v)[3][lanes], int lane)
{
    return {static_cast<double>(v[0][lane]), static_cast<double>(v[1][lane]),
            static_cast<double>(v[2][lane])};
}

/// Whether the ball passes on one side of the border all the time.
bool passes(const Balls& balls, int lane, const Standing& standing, const JoinRules& rules)
{
    const Border& border = standing.border;
    const V3 from = at(balls.from, lane), by = at(balls.by, lane);
    const double radius = static_cast<double>(balls.radius[lane]) + static_cast<double>(rules.grown);
    const double begin = dot(border.normal, from) - border.offset;
    const double end = begin + static_cast<double>(rules.until) * dot(border.normal, by);
    const double room = radius + tolerance::border_room * (sum_of_magnitudes(from) + sum_of_magnitudes(by) +
                                                           standing.lengths + radius);
    if (begin > room && end > room) return true;
    return !border.solid && begin < -room && end < -room;
}

} // namespace

std::uint32_t unbounded_candidates(const Packet& p, const Item& item, const BodyStore& store,
                                   const BroadPhase& broad, const Plan& plan, Candidates& to,
                                   JoinCounts& counts)
{
    const bool resting = item.source != Group::movers && !plan.alone;
    for (std::uint32_t i = item.next; i < broad.unbounded.size(); ++i) {
        const std::uint32_t slot = broad.unbounded[i];
        const Body& body = store.bodies[slot];
        if (resting && at_rest(body) && !plan.rest_pairs) continue;
        if (!to.has_room()) return i;
        const std::optional<Standing> border =
            plan.rules.boxes ? standing_border(body, broad.origin) : std::nullopt;
        for (Mask left = p.held; left != 0; left &= left - 1) {
            const int lane = __builtin_ctz(left);
            if (border && passes(p.balls, lane, *border, plan.rules)) continue;
            ++counts.met;
            to.set(to.count++, {p.slots[lane], slot, 0});
        }
    }
    return no_leaf;
}

} // namespace brink
