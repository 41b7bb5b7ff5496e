// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "crossing.h"
#include "glance.h"
#include "sharp.h"

#include <algorithm>

/// A sphere or capsule against a plane or half-space: whichever end lies lowest stays lowest, so one linear
/// equation decides. First in double arithmetic, then, where it hits, in unevaluated pairs: a rotation matrix
/// of doubles is off by some ten roundings, which a long lever arm shows.
namespace brink {

namespace border {

static inline int ends(const Sphere&) { return 1; }
static inline int ends(const Capsule&) { return 2; }
static inline V3 end(const Sphere&, int) { return {}; }
static inline V3 end(const Capsule& a, int i) { return load(i == 0 ? a.a : a.b); }

template <class Border> constexpr bool is_solid = std::is_same_v<Border, HalfSpace>;

/// Lowest and highest end over the border at t = 0, and how fast A rises.
struct Heights {
    double lowest, highest, rate;
};

/// The same for each end in pairs, times a common factor, less the reach.
struct Sharp {
    Pair height[2];
    Pair rate, reach;
};

template <class A, class Border> Sharp sharpened(const A& a, const Border& b, const Approach& m, Pair radius)
{
    const WholeTurn<Pair> turn_b(m.motion_b.start.orientation);
    const XYZ<Pair> local = pairs(load(b.normal)), normal = turn_b * local;
    const Pair base = dot(normal, sharp::from(m)) - Pair{b.offset} * turn_b.norm_squared;
    const Pair reach = radius * turn_b.norm_squared * square_root(dot(local, local));
    if constexpr (std::is_same_v<A, Sphere>) {
        return {{base, {}}, dot(normal, sharp::by(m)), reach};
    } else {
        const WholeTurn<Pair> turn_a(m.motion_a.start.orientation);
        const Pair factor = turn_a.norm_squared;
        const auto height = [&](int i) { return factor * base + dot(normal, turn_a * pairs(end(a, i))); };
        return {{height(0), height(1)}, factor * dot(normal, sharp::by(m)), factor * reach};
    }
}

} // namespace border

template <class A, class Border> Entry border_entry(const A& a, const Border& b, const Approach& m)
{
    using namespace border;
    const Rotation turn_b = m.turn_b(), turn_a = ends(a) == 2 ? m.turn_a() : Rotation{};
    const V3 local = load(b.normal), normal = turn_b * local;
    const double length = norm(local), radius = a.radius + m.target_gap, near = radius * length;
    V3 at[2];
    double height[2]{};
    double lengths = norm(m.from) + norm(m.by) + radius + std::fabs(b.offset);
    int lowest = 0, highest = 0;
    for (int i = 0; i < ends(a); ++i) {
        at[i] = turn_a * end(a, i);
        height[i] = dot(normal, m.from + at[i]) - b.offset;
        lengths += norm(at[i]);
        if (height[i] < height[lowest]) lowest = i;
        if (height[i] > height[highest]) highest = i;
    }
    const double slack = tolerance::border_slack * lengths, rise = dot(normal, m.by);
    // From which side the border is met, and the nearer end's height on that side.
    const double side = !is_solid<Border> && height[highest] < -near ? -1 : 1;
    const int nearest = side < 0 ? highest : lowest;
    const double above = side * height[nearest] - near, rate = -side * rise;
    if (above < -slack && (is_solid<Border> || height[highest] > slack - near))
        return {.found = Found::start};
    if (above > slack && above - rate * m.t_max > slack) return {.found = Found::apart};
    if (!(above > slack && rate > slack)) return {};

    const Sharp s = sharpened(a, b, m, two_sum(a.radius, m.target_gap));
    const auto over = [&](int i) { return (side < 0 ? -s.height[i] : s.height[i]) - s.reach; };
    Pair clearance = over(0);
    if (ends(a) == 2 && (over(1) - clearance).hi < 0) clearance = over(1);
    const double closing = -side * s.rate.hi, t = clearance.hi / closing;
    const double doubt = t * tolerance::quotient + tolerance::pair_slack * lengths / closing;
    if (!(t > 0 && doubt < 2 * tolerance::quotient * t)) return {};
    const double first = t - doubt, last = t + doubt;
    if (first > m.t_max) return {.found = Found::apart};
    const bool late = last > m.t_max;
    const V3 core = m.from + at[nearest] + first * m.by, unit = (1 / length) * normal;
    const double gap = (near + rate * (t - first)) / length;
    return {late ? Found::doubt : Found::hit, first,        last, late, core,
            core - side * gap * unit,         -side * unit, true};
}

} // namespace brink
