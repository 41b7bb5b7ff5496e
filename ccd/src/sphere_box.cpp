// SPDX-License-Identifier: BSD-3-Clause
#include "crossing.h"
#include "pairs.h"
#include "quadratic.h"
#include "sharp.h"

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
    double in, out;
};

Stay grown(const Slab (&s)[3], double radius, double t_max)
{
    Stay stay{0, t_max};
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
double first_contact(const Slab (&s)[3], double radius, double t_max)
{
    const Stay stay = grown(s, radius, t_max);
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

V3 clamp(V3 p, V3 half) { return {clamp(p.x, half.x), clamp(p.y, half.y), clamp(p.z, half.z)}; }

/// Out of the face that a point outside of one slab only lies over.
V3 face_normal(V3 out)
{
    return {out.x > 0   ? 1.0
            : out.x < 0 ? -1.0
                        : 0,
            out.y > 0   ? 1.0
            : out.y < 0 ? -1.0
                        : 0,
            out.z > 0   ? 1.0
            : out.z < 0 ? -1.0
                        : 0};
}

double support(V3 axis, V3 half)
{
    return std::fabs(axis.x) * half.x + std::fabs(axis.y) * half.y + std::fabs(axis.z) * half.z;
}

/// Whether a point over a face lies inside its sides by more than `margin`.
bool inside_face(V3 point, V3 normal, V3 half, double margin)
{
    const auto in = [margin](double x, double n, double h) { return n != 0 || std::fabs(x) + margin <= h; };
    return in(point.x, normal.x, half.x) && in(point.y, normal.y, half.y) && in(point.z, normal.z, half.z);
}

} // namespace

/// A moving point against the box grown by the sphere's radius: guessed in the box's axes, proven in the
/// world's, where turning does not touch the path.
Entry sphere_box(const Sphere& a, const Box& b, const Approach& m)
{
    const Rotation turn = m.turn_b();
    const V3 from = into(turn, m.from), by = into(turn, m.by), half = load(b.half_extents);
    const Reach r = reach(m, a.radius + m.target_gap, norm(half));
    const Slab slabs[] = {{from.x, by.x, half.x}, {from.y, by.y, half.y}, {from.z, by.z, half.z}};
    const double t = first_contact(slabs, r.radius + r.margin, m.t_max);
    if (t == infinity) return {.found = Found::apart};
    if (t == 0) return {};
    const V3 at = from + t * by, out = at - clamp(at, half);
    const int sides = (out.x != 0) + (out.y != 0) + (out.z != 0);
    const V3 local = sides == 1 ? face_normal(out) : out, axis = turn * local;
    const double height = dot(axis, m.from) - support(local, half);
    const auto later = [&](V3 n, double time) {
        return sharp::later(a, b, m, n, two_sum(a.radius, m.target_gap), r.lengths + norm(half), time);
    };
    if (sides == 1)
        return proven_on_face(
            m, r, axis, height, t,
            [&](V3 foot, double margin) { return inside_face(into(turn, foot), local, half, margin); },
            later);
    return proven(
        m, r, axis, height, t, [&](V3 p) { return turn * clamp(into(turn, p), half); }, later);
}

} // namespace brink
