// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "crossing.h"
#include "glance.h"
#include "sharp.h"

#include <algorithm>

/// A shape with corners or round ends against a plane or half-space: whichever end lies lowest stays lowest,
/// so one linear equation decides. The normal is turned in unevaluated pairs, because a rotation matrix of
/// doubles is off by some ten roundings, which a long lever arm shows; the heights are taken in pairs only
/// where the approach is slow.
namespace brink {

namespace above_border {

/// How many points the core is the hull of.
template <class A> constexpr int ends = 1;
template <> inline constexpr int ends<Capsule> = 2;
template <> inline constexpr int ends<Triangle> = 3;
template <> inline constexpr int ends<Box> = 8;

static inline V3 end(const Sphere&, int) { return {}; }
static inline V3 end(const Capsule& a, int i) { return load(i == 0 ? a.a : a.b); }
static inline V3 end(const Triangle& a, int i) { return load(i == 0 ? a.a : i == 1 ? a.b : a.c); }
static inline V3 end(const Box& a, int i)
{
    const V3 h = load(a.half_extents);
    return {(i & 1) != 0 ? h.x : -h.x, (i & 2) != 0 ? h.y : -h.y, (i & 4) != 0 ? h.z : -h.z};
}

template <class Border> constexpr bool is_solid = std::is_same_v<Border, HalfSpace>;

/// A border's normal in world axes, each component within a few u of the largest, times the squared norm of
/// the quaternion, which is given too.
struct TurnedNormal {
    V3 normal;
    double norm_squared;
};
static inline TurnedNormal turned_normal(V3 local, const Quat& q)
{
    if (q.x() == 0 && q.y() == 0 && q.z() == 0 && q.w() == 1) return {local, 1};
    const WholeTurn<Pair> turn(q);
    const XYZ<Pair> n = turn * pairs(local);
    return {{rounded(n.x), rounded(n.y), rounded(n.z)}, rounded(turn.norm_squared)};
}

/// The heights of A's ends in pairs, how fast they rise, and the reach; all times a common factor.
template <class A> struct Sharp {
    Pair height[ends<A>];
    Pair rate, reach;
};

template <class A, class Border>
Sharp<A> sharpened(const A& a, const Border& b, const Approach& m, Pair radius)
{
    const WholeTurn<Pair> turn_b(m.motion_b.start.orientation);
    const XYZ<Pair> local = pairs(load(b.normal)), normal = turn_b * local;
    const Pair base = dot(normal, sharp::from(m)) - Pair{b.offset} * turn_b.norm_squared;
    const Pair reach = radius * turn_b.norm_squared * square_root(dot(local, local));
    if constexpr (std::is_same_v<A, Sphere>) {
        return {{base}, dot(normal, sharp::by(m)), reach};
    } else {
        const WholeTurn<Pair> turn_a(m.motion_a.start.orientation);
        const Pair factor = turn_a.norm_squared;
        Sharp<A> out{{}, factor * dot(normal, sharp::by(m)), factor * reach};
        for (int i = 0; i < ends<A>; ++i)
            out.height[i] = factor * base + dot(normal, turn_a * pairs(end(a, i)));
        return out;
    }
}

} // namespace above_border

template <class A, class Border> Entry border_entry(const A& a, const Border& b, const Approach& m)
{
    using namespace above_border;
    const auto [normal, norm_squared] = turned_normal(load(b.normal), m.motion_b.start.orientation);
    const Rotation turn_a = ends<A> > 1 ? m.turn_a() : Rotation{};
    const double offset = b.offset * norm_squared, length = norm(normal);
    const double radius = brink::radius(a) + m.target_gap, near = radius * length;
    V3 at[ends<A>];
    double height[ends<A>]{}, extent = 0;
    int lowest = 0, highest = 0;
    for (int i = 0; i < ends<A>; ++i) {
        at[i] = turn_a * end(a, i);
        height[i] = dot(normal, m.from + at[i]) - offset;
        extent = std::max(extent, norm(at[i]));
        if (height[i] < height[lowest]) lowest = i;
        if (height[i] > height[highest]) highest = i;
    }
    const Reach r = reach(m, radius + std::fabs(offset), extent);
    const double slack = r.slack * length;
    // From which side the border is met, and the nearer end's height on that side.
    const double side = !is_solid<Border> && height[highest] < -near ? -1 : 1;
    const int nearest = side < 0 ? highest : lowest;
    const double over = side * height[nearest], rate = -side * dot(normal, m.by);
    if (over - near < -slack && (is_solid<Border> || height[highest] > slack - near))
        return {.found = Found::start};
    if (over - near > slack && over - near - rate * m.t_max > slack) return {.found = Found::apart};
    const Crossing c = crossing(over - near, rate, slack);
    if (!c.closing) return {};
    sharp::Fall f{c.t, c.t_upper};
    if (c.blurred() || r.strained) {
        const Sharp<A> s = sharpened(a, b, m, two_sum(brink::radius(a), m.target_gap));
        const auto above = [&](int i) { return (side < 0 ? -s.height[i] : s.height[i]) - s.reach; };
        Pair least = above(0);
        for (int i = 1; i < ends<A>; ++i)
            if (rounded(above(i) - least) < 0) least = above(i);
        f = sharp::fall(least, side < 0 ? s.rate : -s.rate, tolerance::pair_slack * 2 * (r.lengths + extent));
        if (!(f.t > 0 && f.t_upper - f.t <= tolerance::blur * f.t)) return {};
    }
    if (f.t > m.t_max) return {.found = Found::apart};
    const V3 core = m.from + at[nearest] + f.t * m.by, unit = (1 / length) * normal;
    const double gap = (over - f.t * rate) / length;
    return {f.t_upper > m.t_max ? Found::doubt : Found::hit, f.t, f.t_upper,
            Meeting{core, core - side * gap * unit, -side * unit, true}};
}

} // namespace brink
