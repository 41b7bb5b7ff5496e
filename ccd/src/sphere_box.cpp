// SPDX-License-Identifier: BSD-3-Clause
#include "pairs.h"
#include "quadratic.h"

#include <algorithm>

namespace brink {

namespace {

/// One coordinate of the path against the slab |x| <= half, mirrored so that the point moves towards +x. One
/// that stands still has infinite steps per length, which lead to the right infinities; comparisons with the
/// NaN of a start on the border say inside.
struct Slab {
    double from, by; // by >= 0
    double half;
    double pace;    // 1 / by
    double in, out; // when the point enters and leaves the slab

    Slab(double start, double step, double half_extent)
        : from(step < 0 ? -start : start),
          by(std::fabs(step)),
          half(half_extent),
          pace(1 / by),
          in((-half - from) * pace),
          out((half - from) * pace)
    {
    }
};

/// Latest entry and earliest exit over three slabs grown by `radius`: that box holds the rounded one.
struct Stay {
    double in = 0, out = 1;
};

Stay grown(const Slab (&s)[3], double radius)
{
    Stay stay;
    for (const Slab& axis : s) {
        const double reach = axis.half + radius;
        const double in = (-reach - axis.from) * axis.pace, out = (reach - axis.from) * axis.pace;
        stay.in = in > stay.in ? in : stay.in;
        stay.out = out < stay.out ? out : stay.out;
    }
    return stay;
}

/// Whether the point at the time it enters the grown box is outside of one slab only: it has reached a face.
bool over_face(const Slab (&s)[3], double t)
{
    int outside = 0;
    for (const Slab& axis : s)
        outside += (t < axis.in) | (t >= axis.out);
    return outside == 1;
}

/// How far a coordinate lies outside its slab from time t on, until that changes: offset + t * by.
struct Excess {
    double offset, by;
};

Excess excess(const Slab& s, double t)
{
    const bool before = t < s.in, after = t >= s.out;
    return {before ? s.from + s.half : after ? s.from - s.half : 0, (before | after) ? s.by : 0};
}

double next_change(const Slab& s, double t) { return t < s.in ? s.in : t < s.out ? s.out : infinity; }

/// The squared distance from the box is a quadratic between the times at which some coordinate enters or
/// leaves its slab: at most seven of them, walked in order of time. It is convex, so once it does not fall it
/// never will.
double first_contact(const Slab (&s)[3], double radius)
{
    const Stay stay = grown(s, radius);
    double t = stay.in;
    if (t > 0 && t <= stay.out && over_face(s, t)) return t;
    while (t <= stay.out) {
        const Excess x = excess(s[0], t), y = excess(s[1], t), z = excess(s[2], t);
        const V3 offset{x.offset, y.offset, z.offset}, by{x.by, y.by, z.by};
        const V3 now = offset + t * by;
        const double c = norm_squared(now) - radius * radius, closing = -dot(now, by);
        if (c <= 0) return t;
        if (closing <= 0) return infinity;
        const double next = std::min({next_change(s[0], t), next_change(s[1], t), next_change(s[2], t)});
        const double root = ray_ball(offset, by, radius);
        if (root <= next) return std::max(root, t);
        t = next;
    }
    return infinity;
}

double clamp(double x, double half) { return x < -half ? -half : x > half ? half : x; }

/// Out of the box through the face whose slab the point entered last: the one it lies on when the sphere has
/// no radius.
V3 last_face(const Slab (&s)[3], V3 by)
{
    const int last = s[0].in >= s[1].in && s[0].in >= s[2].in ? 0 : s[1].in >= s[2].in ? 1 : 2;
    return {last == 0 ? by.x : 0, last == 1 ? by.y : 0, last == 2 ? by.z : 0};
}

} // namespace

/// A moving point against the box grown by the sphere's radius, in the box's axes.
Entry sphere_box(const Sphere& a, const Box& b, const Approach& m)
{
    const Rotation turn = m.turn_b();
    const V3 from = into(turn, m.from), by = into(turn, m.by), half = load(b.half_extents);
    const Slab slabs[] = {{from.x, by.x, half.x}, {from.y, by.y, half.y}, {from.z, by.z, half.z}};
    const double t = first_contact(slabs, a.radius + m.target_gap);
    if (t == 0 || t == infinity) return {.t = t};
    const V3 at = from + t * by, nearest{clamp(at.x, half.x), clamp(at.y, half.y), clamp(at.z, half.z)};
    const V3 out = nearest - at;
    const int sides = (out.x != 0) + (out.y != 0) + (out.z != 0);
    return {t, turn * at, turn * nearest, turn * (sides == 1 ? out : last_face(slabs, by)), sides <= 1};
}

} // namespace brink
