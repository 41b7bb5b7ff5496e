// SPDX-License-Identifier: BSD-3-Clause
#include <brink/discrete.h>

#include "ray_triangle.h"
#include "validity.h"

namespace brink::discrete {

namespace {

bool is_finite(const Segment& s) { return brink::is_finite(load(s.from)) && brink::is_finite(load(s.to)); }
bool is_finite(const Ball& b) { return brink::is_finite(load(b.centre)) && is_size(b.radius); }

SegmentHit hit_at(const Segment& segment, double t, V3 barycentric)
{
    const V3 from = load(segment.from), to = load(segment.to);
    // Exact at both ends.
    const V3 point = t == 1 ? to : from + t * (to - from);
    return {true, t, store(point), store(barycentric)};
}

} // namespace

bool overlap(const Ball& a, const Ball& b)
{
    const V3 apart = load(b.centre) - load(a.centre);
    const double radii = a.radius + b.radius;
    return is_finite(a) && is_finite(b) && norm_squared(apart) <= radii * radii;
}

bool overlap(const Aabb& a, const Aabb& b)
{
    const V3 a_min = load(a.min), a_max = load(a.max), b_min = load(b.min), b_max = load(b.max);
    return a_min.x <= b_max.x && b_min.x <= a_max.x && a_min.y <= b_max.y && b_min.y <= a_max.y &&
           a_min.z <= b_max.z && b_min.z <= a_max.z;
}

bool overlap(const Ball& ball, const Plane& plane)
{
    if (!is_finite(ball) || !valid(plane)) return false;
    return std::fabs(dot(load(plane.normal), load(ball.centre)) - plane.offset) <= ball.radius;
}

SegmentHit first_meeting(const Segment& segment, const Plane& plane)
{
    if (!is_finite(segment) || !valid(plane)) return {};
    const V3 normal = load(plane.normal);
    const double from = dot(normal, load(segment.from)) - plane.offset;
    const double to = dot(normal, load(segment.to)) - plane.offset;
    if (from == 0) return hit_at(segment, 0, {});
    if (to == 0) return hit_at(segment, 1, {});
    // Heights of both signs, neither zero: no division by zero and t within (0, 1).
    if (!((from > 0 && to < 0) || (from < 0 && to > 0))) return {};
    return hit_at(segment, from / (from - to), {});
}

SegmentHit first_meeting(const Segment& segment, const Triangle& triangle)
{
    if (!is_finite(segment) || !valid(triangle)) return {};
    const V3 from = load(segment.from), along = load(segment.to) - from;
    const RayEntry entry =
        ray_triangle(along, load(triangle.a) - from, load(triangle.b) - from, load(triangle.c) - from);
    return entry.t <= 1 ? hit_at(segment, entry.t, entry.weights) : SegmentHit{};
}

} // namespace brink::discrete
