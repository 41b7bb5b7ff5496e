// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "approach.h"
#include "tolerance.h"
#include "whole_turn.h"

#include <brink/shape.h>

#include <algorithm>

/// Heights in unevaluated pairs, from the doubles that the caller gave: for times whose rounding would show.
namespace brink::sharp {

using V = XYZ<Pair>;

static inline V vector(V3 hi, V3 lo) { return {{hi.x, lo.x}, {hi.y, lo.y}, {hi.z, lo.z}}; }
static inline V from(const Approach& m) { return vector(m.from, m.from_low()); }
static inline V by(const Approach& m) { return vector(m.by, m.by_low()); }

static inline Pair greater(Pair a, Pair b) { return rounded(b - a) > 0 ? b : a; }
static inline Pair magnitude(Pair a) { return rounded(a) < 0 ? -a : a; }

/// The most that a core's points reach along an axis, both local.
static inline Pair support(const Sphere&, const V&) { return {}; }
static inline Pair support(const Capsule& s, const V& n)
{
    return greater(dot(n, pairs(load(s.a))), dot(n, pairs(load(s.b))));
}
static inline Pair support(const Triangle& s, const V& n)
{
    const Pair ab = greater(dot(n, pairs(load(s.a))), dot(n, pairs(load(s.b))));
    return greater(ab, dot(n, pairs(load(s.c))));
}
static inline Pair support(const Box& s, const V& n)
{
    const V half = pairs(load(s.half_extents));
    return magnitude(n.x) * half.x + magnitude(n.y) * half.y + magnitude(n.z) * half.z;
}

/// The same of a turned core along a world axis, times the squared norm of its quaternion, which is given
/// too.
struct Support {
    Pair most, norm_squared;
};
static inline Support support(const Sphere&, const Quat&, const V&) { return {{}, {1}}; }
template <class Shape> Support support(const Shape& s, const Quat& q, const V& axis)
{
    const WholeTurn<Pair> turn(q);
    return {support(s, turn.into(axis)), turn.norm_squared};
}

/// When a height has fallen to nothing, rounded down. `slack`: what the height may be off by.
struct Fall {
    double t, t_upper;
};
static inline Fall fall(Pair above, Pair rate, double slack)
{
    const double fast = rounded(rate), t = rounded(above) / fast;
    if (!(fast > 0 && t > 0)) return {0, infinity};
    const double doubt = t * tolerance::quotient + slack / fast;
    return {t - doubt, t + doubt};
}

/// What decides when A's and B's supporting planes at right angles to an axis are the reach apart, all times
/// a common factor.
struct Height {
    Pair above; // the reach, at t = 0
    Pair rate;  // how fast it falls
};

/// `axis` leads from B to A.
template <class A, class B> Height height(const A& a, const B& b, const Approach& m, V3 axis, Pair radius)
{
    const V n = pairs(axis);
    const Support on_a = support(a, m.motion_a.start.orientation, -n),
                  on_b = support(b, m.motion_b.start.orientation, n);
    const Pair factor = on_a.norm_squared * on_b.norm_squared;
    const Pair between =
        factor * dot(n, from(m)) - on_a.norm_squared * on_b.most - on_b.norm_squared * on_a.most;
    return {between - factor * radius * square_root(dot(n, n)), -(factor * dot(n, by(m)))};
}

/// The time that pairs prove where doubles proved only `t`: no earlier than that.
template <class A, class B>
[[gnu::noinline]] double later(const A& a, const B& b, const Approach& m, V3 axis, Pair radius,
                               double lengths, double t)
{
    const Height h = height(a, b, m, axis, radius);
    return std::max(t, fall(h.above, h.rate, tolerance::pair_slack * lengths * norm(axis)).t);
}

} // namespace brink::sharp
