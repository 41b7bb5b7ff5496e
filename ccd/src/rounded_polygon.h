// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "approach.h"
#include "quadratic.h"
#include "tolerance.h"

namespace brink {

/// A moving point against a segment grown by a radius, without its two ends.
struct EdgeEntry {
    double t;     // infinite: not between the ends
    double along; // where on the edge, 0 to 1
};

/// Crossing everything with the edge drops the component along it and leaves |edge x (m + t by)| = radius
/// |edge|, the infinite cylinder. Its discriminant factors through edge . (m x by), so that a far start keeps
/// its closest approach.
static inline EdgeEntry edge_entry(V3 m, V3 by, V3 edge, double radius)
{
    const double length_squared = norm_squared(edge), reach_squared = radius * radius;
    const V3 outward = cross(edge, m), drift = cross(edge, by);
    const double c = norm_squared(outward) - reach_squared * length_squared;
    const double triple = dot(m, drift);
    const double discriminant = reach_squared * norm_squared(drift) - triple * triple;
    const double t = first_root(dot(outward, drift), c, length_squared * discriminant);
    const double along = (dot(edge, m) + (t < infinity ? t : 0) * dot(edge, by)) / length_squared;
    const bool between = (along >= 0) & (along <= 1); // false for an edge without length
    return {between ? t : infinity, along};
}

/// A moving point against the outline of a polygon with N corners (N = 2: one segment), grown by `radius`:
/// the least over its edges and the balls at its corners, for the balls are part of the grown outline.
template <int N> Entry outline_entry(const V3 (&corner)[N], V3 from, V3 by, double radius)
{
    constexpr int edges = N == 2 ? 1 : N;
    EdgeEntry edge[edges];
    double ball[N];
    for (int i = 0; i < edges; ++i)
        edge[i] = edge_entry(from - corner[i], by, corner[(i + 1) % N] - corner[i], radius);
    for (int i = 0; i < N; ++i)
        ball[i] = ray_ball(from - corner[i], by, radius);

    int first_edge = 0, first_ball = 0;
    for (int i = 1; i < edges; ++i)
        first_edge = edge[i].t < edge[first_edge].t ? i : first_edge;
    for (int i = 1; i < N; ++i)
        first_ball = ball[i] < ball[first_ball] ? i : first_ball;
    const bool on_edge = edge[first_edge].t <= ball[first_ball];
    const double t = on_edge ? edge[first_edge].t : ball[first_ball];
    if (t == 0 || t == infinity) return {.t = t};

    const V3 start = corner[on_edge ? first_edge : first_ball];
    if (!on_edge) return {t, from + t * by, start, by};
    const V3 direction = corner[(first_edge + 1) % N] - start;
    const V3 across = by - (dot(by, direction) / norm_squared(direction)) * direction;
    return {t, from + t * by, start + edge[first_edge].along * direction, across};
}

/// Whether the path's straight line passes a ball.
static inline bool passes(V3 from, V3 by, V3 centre, double radius)
{
    return norm_squared(cross(from - centre, by)) > radius * radius * norm_squared(by);
}

/// Whether a point in the plane of a polygon lies inside an edge. Nearer to the edge's line than rounding can
/// tell, it must also lie between the edge's ends: otherwise a sliver, all of it that near, would reach
/// beyond its tips.
static inline bool inside_edge(V3 inward, V3 edge, V3 m, double margin)
{
    const double depth = dot(inward, m), along = dot(edge, m);
    return (depth >= margin) | ((depth > -margin) & (along >= 0) & (along <= norm_squared(edge)));
}

/// A convex polygon with counter-clockwise corners about `normal` (of any length, and right however small),
/// and a ball that holds it.
template <int N> struct Polygon {
    V3 corner[N];
    V3 normal;
    V3 centre;
    double reach;
};

/// A moving point against a filled polygon grown by `radius`. The path enters the slab of points within
/// `radius` of the plane; over the polygon that is contact, elsewhere only the outline can be met.
template <int N> Entry polygon_entry(const Polygon<N>& p, V3 from, V3 by, double radius)
{
    if (passes(from, by, p.centre, (p.reach + radius) * (1 + 0x1p-40))) return {};
    const double length_squared = norm_squared(p.normal), length = std::sqrt(length_squared);
    const double height = dot(p.normal, from - p.corner[0]), side = height < 0 ? -1 : 1;
    const double above = side * height - radius * length, climb = side * dot(p.normal, by);
    if (above > 0 && !(above <= -climb)) return {}; // later than t = 1
    const double t = above > 0 ? above / -climb : 0;
    const V3 at = from + t * by;
    const double scale =
        sum_of_magnitudes(from) + sum_of_magnitudes(by) + sum_of_magnitudes(p.centre) + p.reach;
    const double margin = tolerance::core_noise * length * scale;
    bool over = length > 0;
    for (int i = 0; i < N; ++i) {
        const V3 edge = p.corner[(i + 1) % N] - p.corner[i];
        over &= inside_edge(cross(p.normal, edge), edge, at - p.corner[i], margin * sum_of_magnitudes(edge));
    }
    if (!over) return outline_entry(p.corner, from, by, radius);
    const double lift = dot(p.normal, at - p.corner[0]) / length_squared;
    return {t, at, at - lift * p.normal, -side * p.normal};
}

} // namespace brink
