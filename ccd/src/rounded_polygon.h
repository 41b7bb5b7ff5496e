// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "approach.h"
#include "quadratic.h"
#include "tolerance.h"

/// A moving point against a segment or a convex polygon, grown by a radius. Internal linkage, so that each
/// pair's source has it inline.
namespace brink {

/// Edges, two at a time, without their ends: when the point first is within `radius` of one.
struct EdgeEntry {
    Two t;     // infinite: never, or not between the ends
    Two along; // where on the edge, 0 to 1
};

/// `m` leads from the edge's start to the point. Crossing everything with the edge drops the component along
/// it and leaves |edge x (m + t by)| = radius |edge|, the infinite cylinder. Its discriminant factors through
/// edge . (m x by), so that a far start keeps its closest approach.
static inline EdgeEntry edge_entry(XYZ<Two> m, XYZ<Two> by, XYZ<Two> edge, Two radius)
{
    const Two length_squared = norm_squared(edge), reach_squared = radius * radius;
    const XYZ<Two> outward = cross(edge, m), drift = cross(edge, by);
    const Two c = norm_squared(outward) - reach_squared * length_squared;
    const Two triple = dot(m, drift);
    const Two discriminant = reach_squared * norm_squared(drift) - triple * triple;
    const Two t = first_root(dot(outward, drift), c, length_squared * discriminant);
    const Two along = (dot(edge, m) + select(t < infinity, t, both(0)) * dot(edge, by)) / length_squared;
    const TwoFlags between = (along >= 0) & (along <= 1); // false for an edge without length
    return {select(between, t, both(infinity)), along};
}

/// The normal where the point touches the edge itself: against the motion, across the edge.
static inline V3 across_edge(V3 by, V3 edge) { return by - (dot(by, edge) / norm_squared(edge)) * edge; }

/// Against one segment: the least over its side and the balls at its ends, which are part of it.
static inline Entry segment_entry(V3 start, V3 end, V3 from, V3 by, double radius)
{
    const V3 edge = end - start;
    const XYZ<Two> m = pair(from - start, from - end);
    const EdgeEntry side = edge_entry(m, both(by), both(edge), both(radius));
    const Two balls = ray_ball(m, both(by), both(radius));
    const double ball = balls[1] < balls[0] ? balls[1] : balls[0];
    const double t = side.t[0] < ball ? side.t[0] : ball;
    if (t == 0 || t == infinity) return {.t = t};
    const V3 at = from + t * by;
    if (side.t[0] <= ball) return {t, at, start + side.along[0] * edge, across_edge(by, edge), false};
    return {t, at, balls[1] < balls[0] ? end : start, by, false};
}

/// A convex polygon of four corners (a triangle repeats its first one), counter-clockwise about `normal`,
/// which is of any length and right however small, and a ball that holds it. By coordinates, so that a
/// compiler can take the corners side by side.
struct Polygon {
    V3 corner[4];
    V3 normal;
    V3 centre;
    double reach;

    V3 edge(int k) const { return corner[(k + 1) % 4] - corner[k]; }
    /// The first two corners or edges (i = 0) or the last two (i = 2).
    XYZ<Two> corners(int i) const { return pair(corner[i], corner[i + 1]); }
    XYZ<Two> edges(int i) const { return pair(edge(i), edge(i + 1)); }
};

/// Where a point meets a grown polygon first.
struct PolygonEntry {
    Entry entry;
    int edge = -1;    // met between its ends, or at one of them; -1: the face
    double along = 0; // where on that edge, 0 to 1
};

/// Against the outline: the least over its edges and the balls at its corners.
static inline PolygonEntry outline_entry(const Polygon& p, V3 from, V3 by, double radius)
{
    double side[4], along[4], ball[4];
    for (int i = 0; i < 4; i += 2) {
        const XYZ<Two> m = both(from) - p.corners(i);
        const EdgeEntry e = edge_entry(m, both(by), p.edges(i), both(radius));
        const Two b = ray_ball(m, both(by), both(radius));
        for (int k = 0; k < 2; ++k) {
            side[i + k] = e.t[k];
            along[i + k] = e.along[k];
            ball[i + k] = b[k];
        }
    }
    int first_side = 0, first_ball = 0;
    for (int k = 1; k < 4; ++k) {
        first_side = side[k] < side[first_side] ? k : first_side;
        first_ball = ball[k] < ball[first_ball] ? k : first_ball;
    }
    const bool on_side = side[first_side] <= ball[first_ball];
    const double t = on_side ? side[first_side] : ball[first_ball];
    if (t == 0 || t == infinity) return {{.t = t}};
    const V3 at = from + t * by;
    if (!on_side) return {{t, at, p.corner[first_ball], by, false}, first_ball, 0};
    const V3 edge = p.edge(first_side);
    const V3 met = p.corner[first_side] + along[first_side] * edge;
    return {{t, at, met, across_edge(by, edge), false}, first_side, along[first_side]};
}

/// Whether the path's straight line passes a ball.
static inline bool passes(V3 from, V3 by, V3 centre, double radius)
{
    return norm_squared(cross(from - centre, by)) > radius * radius * norm_squared(by);
}

/// Whether a point in the polygon's plane lies inside it. Nearer to an edge's line than rounding can tell, it
/// must also lie between that edge's ends: otherwise a sliver, all of it that near, would reach beyond its
/// tips.
static inline bool inside(const Polygon& p, V3 at, double margin)
{
    TwoFlags all{-1, -1};
    for (int i = 0; i < 4; i += 2) {
        const XYZ<Two> edge = p.edges(i), m = both(at) - p.corners(i);
        const Two depth = dot(cross(both(p.normal), edge), m), along = dot(edge, m),
                  length_squared = norm_squared(edge);
        const Two doubt = both(margin) * square_root(length_squared);
        all &= (depth >= doubt) | ((depth > -doubt) & (along >= 0) & (along <= length_squared));
    }
    return (all[0] & all[1]) != 0;
}

/// Against the filled polygon. The path enters the slab of points within `radius` of its plane; over the
/// polygon that is contact, elsewhere only the outline can be met.
static inline PolygonEntry polygon_entry(const Polygon& p, V3 from, V3 by, double radius)
{
    if (passes(from, by, p.centre, (p.reach + radius) * (1 + tolerance::holding_slack))) return {};
    const double length_squared = norm_squared(p.normal), length = std::sqrt(length_squared);
    const double height = dot(p.normal, from - p.corner[0]), side = height < 0 ? -1 : 1;
    const double above = side * height - radius * length, climb = side * dot(p.normal, by);
    if (above > 0 && !(above <= -climb)) return {}; // later than t = 1
    const double t = above > 0 ? above / -climb : 0;
    const V3 at = from + t * by;
    const double scale =
        sum_of_magnitudes(from) + sum_of_magnitudes(by) + sum_of_magnitudes(p.centre) + p.reach;
    if (!(length > 0) || !inside(p, at, tolerance::core_noise * length * scale))
        return outline_entry(p, from, by, radius);
    const double lift = dot(p.normal, at - p.corner[0]) / length_squared;
    return {{t, at, at - lift * p.normal, -side * p.normal, true}};
}

} // namespace brink
