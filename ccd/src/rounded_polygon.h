// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "crossing.h"
#include "quadratic.h"

/// A moving point against a segment or a convex polygon, grown by a radius: first a guess in plain double
/// arithmetic, with radii so much larger that no rounding can miss, then a proof along the axis of the
/// feature met. Internal linkage, so that each pair's source has it inline.
namespace brink {

/// Edges, two at a time, without their ends: when the point first is within `radius` of one.
struct EdgeEntry {
    Two t;     // infinite: never, or not between the ends
    Two along; // where on the edge, 0 to 1
};

/// `m` leads from the edge's start to the point; `drift` is edge x by. Crossing everything with the edge
/// drops the component along it and leaves |edge x (m + t by)| = radius |edge|, the infinite cylinder. Its
/// discriminant factors through edge . (m x by), so that a far start keeps its closest approach.
static inline EdgeEntry edge_entry(XYZ<Two> m, XYZ<Two> by, XYZ<Two> edge, XYZ<Two> drift, Two radius)
{
    const Two length_squared = norm_squared(edge), reach_squared = radius * radius;
    const XYZ<Two> outward = cross(edge, m);
    const Two c = norm_squared(outward) - reach_squared * length_squared;
    const Two triple = dot(m, drift);
    const Two discriminant = reach_squared * norm_squared(drift) - triple * triple;
    const Two t = first_root(dot(outward, drift), c, length_squared * discriminant);
    const Two along = (dot(edge, m) + select(t < infinity, t, both(0)) * dot(edge, by)) / length_squared;
    const TwoFlags between = (along >= 0) & (along <= 1); // false for an edge without length
    return {select(between, t, both(infinity)), along};
}

/// The radii that features are looked for with: each kind larger than the one it ends at, so that nothing
/// slips through where they meet.
static inline double face_radius(const Reach& r) { return r.radius + r.margin; }
static inline double edge_radius(const Reach& r) { return r.radius + 2 * r.margin; }
static inline double corner_radius(const Reach& r) { return r.radius + 3 * r.margin; }

static inline double clamped(double s) { return s < 0 ? 0 : s > 1 ? 1 : s; }

/// Where on an edge, 0 to 1, a point comes nearest; 0 where the edge has no length.
static inline double nearest_on_edge(V3 start, V3 edge, V3 point)
{
    const double length_squared = norm_squared(edge);
    return length_squared == 0 ? 0 : clamped(dot(point - start, edge) / length_squared);
}

/// From an edge to a point, at right angles to the edge.
static inline V3 across(V3 start, V3 edge, V3 point)
{
    const V3 m = point - start, off = m - (dot(m, edge) / norm_squared(edge)) * edge;
    return off - (dot(off, edge) / norm_squared(edge)) * edge;
}

/// Met at an edge between its ends, or at a corner: proven along the axis from there.
template <class Height, class Later>
[[gnu::always_inline]] inline Entry proven_on_edge(const Approach& m, const Reach& r, V3 start, V3 edge,
                                                   double early, Height height, Later later)
{
    const V3 axis = across(start, edge, m.from + early * m.by);
    return proven(
        m, r, axis, height(axis), early, [&](V3 p) { return start + nearest_on_edge(start, edge, p) * edge; },
        later);
}
template <class Height, class Later>
[[gnu::always_inline]] inline Entry proven_at_corner(const Approach& m, const Reach& r, V3 corner,
                                                     double early, Height height, Later later)
{
    const V3 axis = m.from + early * m.by - corner;
    return proven(
        m, r, axis, height(axis), early, [&](V3) { return corner; }, later);
}

/// Against one segment: the least over its side and the balls at its ends.
template <class Later> Entry segment_entry(V3 start, V3 end, const Approach& m, const Reach& r, Later later)
{
    const V3 edge = end - start;
    const XYZ<Two> from = pair(m.from - start, m.from - end), by = both(m.by), edges = both(edge);
    const EdgeEntry side = edge_entry(from, by, edges, careful_cross(edges, by), both(edge_radius(r)));
    const Two balls = ray_ball(from, by, both(corner_radius(r)));
    const double ball = balls[1] < balls[0] ? balls[1] : balls[0];
    const double t = side.t[0] < ball ? side.t[0] : ball;
    if (t > m.t_max) return {.found = Found::apart};
    if (t == 0) return {};
    const auto height = [&](V3 axis) {
        const Two heights = dot(both(axis), from);
        return heights[1] < heights[0] ? heights[1] : heights[0];
    };
    if (side.t[0] <= ball) return proven_on_edge(m, r, start, edge, t, height, later);
    return proven_at_corner(m, r, balls[1] < balls[0] ? end : start, t, height, later);
}

/// A convex polygon of four corners (a triangle repeats its first one), counter-clockwise about `normal`,
/// which is of any length and right however small, and a ball that holds it.
struct Polygon {
    V3 corner[4];
    V3 edge[4]; // from each corner to the next
    V3 normal;
    V3 centre;
    double reach;
    bool parallelogram;

    /// The first two corners or edges (i = 0) or the last two (i = 2).
    XYZ<Two> corners(int i) const { return pair(corner[i], corner[i + 1]); }
    XYZ<Two> edges(int i) const { return pair(edge[i], edge[i + 1]); }
};

/// Where a point meets a grown polygon first.
struct PolygonEntry {
    Entry entry;
    int edge = -1; // met between its ends, or at its start; -1: the face
};

/// The polygon's corners seen from the point at the start.
struct Seen {
    XYZ<Two> first, last; // corners 0 and 1, 2 and 3: from the corner to the point

    Seen(const Polygon& p, V3 from) : first(both(from) - p.corners(0)), last(both(from) - p.corners(2)) {}
    /// The least height of the point over the corners.
    double height(V3 axis) const
    {
        const Two a = dot(both(axis), first), b = dot(both(axis), last);
        const Two low = select(a < b, a, b);
        return low[1] < low[0] ? low[1] : low[0];
    }
};

/// Against the outline: the least over its edges and the balls at its corners.
template <class Later>
PolygonEntry outline_entry(const Polygon& p, const Approach& m, const Reach& r, const Seen& seen, Later later)
{
    const XYZ<Two> by = both(m.by), drift = careful_cross(p.edges(0), by);
    const XYZ<Two> other = p.parallelogram ? -drift : careful_cross(p.edges(2), by);
    const Two edge_reach = both(edge_radius(r)), ball_reach = both(corner_radius(r));
    const EdgeEntry first = edge_entry(seen.first, by, p.edges(0), drift, edge_reach);
    const EdgeEntry last = edge_entry(seen.last, by, p.edges(2), other, edge_reach);
    const Two ball_first = ray_ball(seen.first, by, ball_reach),
              ball_last = ray_ball(seen.last, by, ball_reach);
    const double side[] = {first.t[0], first.t[1], last.t[0], last.t[1]};
    const double ball[] = {ball_first[0], ball_first[1], ball_last[0], ball_last[1]};
    int first_side = 0, first_ball = 0;
    for (int k = 1; k < 4; ++k) {
        first_side = side[k] < side[first_side] ? k : first_side;
        first_ball = ball[k] < ball[first_ball] ? k : first_ball;
    }
    const bool on_side = side[first_side] <= ball[first_ball];
    const double t = on_side ? side[first_side] : ball[first_ball];
    if (t > m.t_max) return {{.found = Found::apart}};
    if (t == 0) return {};
    const auto height = [&](V3 axis) { return seen.height(axis); };
    if (!on_side) return {proven_at_corner(m, r, p.corner[first_ball], t, height, later), first_ball};
    return {proven_on_edge(m, r, p.corner[first_side], p.edge[first_side], t, height, later), first_side};
}

/// Whether the path's straight line passes a ball.
static inline bool passes(V3 from, V3 by, V3 centre, double radius)
{
    return norm_squared(cross(from - centre, by)) > radius * radius * norm_squared(by) + tolerance::nothing;
}

enum class Edges : unsigned char {
    blurred, // a point nearer to an edge's line than the margin counts as inside when it lies between the
             // ends
    strict   // inside is what lies inside of every edge by more than the margin
};

/// Whether a point in the polygon's plane lies inside it.
static inline bool inside(const Polygon& p, V3 at, double margin, Edges edges)
{
    TwoFlags all{-1, -1};
    for (int i = 0; i < 4; i += 2) {
        const XYZ<Two> edge = p.edges(i), m = both(at) - p.corners(i);
        const Two depth = dot(cross(both(p.normal), edge), m), length_squared = norm_squared(edge);
        const Two doubt = both(margin) * square_root(length_squared);
        TwoFlags in = depth >= doubt;
        if (edges == Edges::blurred) {
            const Two along = dot(edge, m);
            in |= (depth > -doubt) & (along >= 0) & (along <= length_squared);
        }
        all &= in;
    }
    return (all[0] & all[1]) != 0;
}

/// Against the filled polygon. The path enters the slab of points within `radius` of its plane; over the
/// polygon that is contact, elsewhere only the outline can be met.
template <class Later>
PolygonEntry polygon_entry(const Polygon& p, const Approach& m, const Reach& r, Later later)
{
    const double wide = corner_radius(r);
    if (passes(m.from, m.by, p.centre, (p.reach + wide) * (1 + tolerance::holding_slack)))
        return {{.found = Found::apart}};
    const Seen seen(p, m.from);
    const double length = norm(p.normal);
    if (!(length > tolerance::smallest_normal)) return outline_entry(p, m, r, seen, later);
    const double height = dot(p.normal, m.from - p.corner[0]), side = height < 0 ? -1 : 1;
    const V3 out = side * p.normal;
    const double above = side * height - face_radius(r) * length, climb = dot(out, m.by);
    if (above > 0 && !(above <= -climb * m.t_max)) return {{.found = Found::apart}};
    const double t = above > 0 ? above / -climb : 0;
    const V3 at = m.from + t * m.by;
    if (!inside(p, at, r.margin * length, Edges::blurred)) return outline_entry(p, m, r, seen, later);
    if (t == 0) return {};
    const auto deep = [&](V3 foot, double margin) { return inside(p, foot, margin * length, Edges::strict); };
    return {proven_on_face(m, r, out, seen.height(out), t, deep, later)};
}

} // namespace brink
