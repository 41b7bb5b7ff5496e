// SPDX-License-Identifier: BSD-3-Clause
#include "polytope.h"

#include "depth.h"
#include "epa.h"
#include "feature_pairs.h"
#include "gjk.h"
#include "nearest.h"
#include "point_round.h"
#include "round_axis.h"
#include "sat.h"
#include "support.h"
#include "tolerance.h"

#include <algorithm>

namespace brink {

namespace {

constexpr int most_returns = 64; // a rim beside a face comes nearer by a third or so each time

/// The corners of a core that its supporting plane touches, which is that far along n.
Patch touched(const Core& c, V3 n, double height, double slack)
{
    unsigned corners = 0;
    for (int k = 0; k < c.count; ++k)
        if (std::fabs(dot(corner(c, k), n) - height) <= slack) corners |= 1U << k;
    return {c, corners};
}

/// Where the two touch once B is moved along the axis by its gap: the witness points, and what is left
/// between.
NearestPair contact(const Core& a, const Core& b, const Axis& axis, double slack)
{
    const Core moved = placed(b, Rotation{}, -axis.gap * axis.normal);
    const double height = interval(a, axis.normal).high;
    const NearestPair pair =
        nearest_features(touched(a, axis.normal, height, slack), touched(moved, axis.normal, height, slack));
    // Of two nearly parallel faces rounding may choose the one beside which the deepest points lie.
    return pair.square <= slack * slack ? pair : nearest_features({a}, {moved});
}

Separation overlapping(const Core& a, const Core& b, const Axis& axis, double slack)
{
    const V3 point_a = contact(a, b, axis, slack).point_a;
    return {axis.gap, axis.gap, axis.normal, point_a, point_a + axis.gap * axis.normal};
}

/// The gap, from the distance of the witness points and the lower bound. What is left between the points of
/// cores that touch is rounding, and never 0: the supporting planes know better.
double certified(double distance, double lower, double slack)
{
    return distance <= slack ? std::min(distance, lower) : distance;
}

/// Of two axes the one with the larger gap; the first, where it is within the slack of the distance.
Axis preferred(const Axis& first, const Axis& second, double enough)
{
    return first.gap >= enough || !(second.gap > first.gap) ? first : second;
}

Axis along(const Core& a, const Core& b, V3 n)
{
    const double length = norm(n);
    if (!(length > 0)) return {};
    n = (1 / length) * n;
    return {gap_along(a, b, n), n};
}

/// Cores apart, by an axis that is certain of the distance, where witness points are as far apart in many
/// places up to rounding, and the nearest of all features were not those that the axis leads to.
Separation by_axis(const Core& a, const Core& b, const Axis& axis, double slack)
{
    const NearestPair rest = contact(a, b, axis, slack);
    const V3 v = axis.gap * axis.normal + rest.v;
    const double distance = norm(v);
    const Axis better = along(a, b, v);
    if (better.gap >= distance - slack)
        return {std::min(better.gap, distance), distance, better.normal, rest.point_a, rest.point_a + v};
    return {axis.gap, axis.gap, axis.normal, rest.point_a, rest.point_a + v};
}

/// Cores apart, or only just touching, that GJK was not certain about.
Separation by_features(const Core& a, const Core& b, const Axis& axis, double slack)
{
    const NearestPair pair = nearest_features({a}, {b});
    const double distance = std::sqrt(pair.square), enough = distance > slack ? distance - slack : infinity;
    Axis best = along(a, b, pair.v);
    for (const Directions& d : {directions(a), directions(b)})
        for (int k = 0; k < d.edges; ++k)
            best = preferred(best, along(a, b, across(pair.v, d.edge[k])), enough);
    best = preferred(best, axis, enough);
    if (distance > slack && best.gap >= enough && norm(pair.v - distance * best.normal) > slack)
        return by_axis(a, b, best, slack);
    return {std::min(best.gap, distance), certified(distance, best.gap, slack), best.normal, pair.point_a,
            pair.point_a + pair.v};
}

/// The edges of a core, of a hull those about the corners that a simplex names.
struct Edges {
    static constexpr int most = 32;
    int count = 0;
    V3 along[most];

    Edges(const Core& core, const Simplex& s, int Simplex::Corner::*name)
    {
        if (core.kind != Core::Kind::hull) {
            const Directions d = directions(core);
            std::for_each(d.edge, d.edge + d.edges, [&](V3 e) { add(e); });
            return;
        }
        const HullData& hull = *core.hull;
        for (int k = 0; k < s.size && !hull.neighbours.empty(); ++k) {
            const int from = s.corners[k].*name;
            const auto first = hull.neighbours.begin() + hull.first_neighbour[static_cast<std::size_t>(from)];
            const auto last =
                hull.neighbours.begin() + hull.first_neighbour[static_cast<std::size_t>(from) + 1];
            std::for_each(first, last, [&](int to) { add(corner(core, to) - corner(core, from)); });
        }
    }

private:
    void add(V3 edge)
    {
        if (count < most) along[count++] = edge;
    }
};

/// Cores apart by v or hardly less. Where a face is nearly at right angles to v an edge or a corner is as
/// near as doubles tell, and where an edge is a corner, so that v leads beside the axis of the distance: that
/// of the faces and edges about.
Axis by_neighbours(const Core& a, const Core& b, Axis best, const Closest& c, double enough)
{
    const auto ask = [&](V3 n) {
        if (best.gap < enough) best = preferred(best, along(a, b, dot(n, c.v) < 0 ? -n : n), enough);
    };
    for (const Core* core : {&a, &b}) {
        const Directions d = directions(*core);
        std::for_each(d.face, d.face + d.faces, ask);
        if (core->kind == Core::Kind::hull) ask(face_towards(*core, core == &a ? c.v : -c.v));
    }
    if (best.gap >= enough) return best;
    const Edges of_a(a, c.simplex, &Simplex::Corner::in_a), of_b(b, c.simplex, &Simplex::Corner::in_b);
    for (const Edges* edges : {&of_a, &of_b})
        std::for_each(edges->along, edges->along + edges->count, [&](V3 e) { ask(across(c.v, e)); });
    for (int i = 0; i < of_a.count; ++i)
        for (int k = 0; k < of_b.count; ++k)
            ask(common_normal(of_a.along[i], of_b.along[k]));
    return best;
}

/// Polytopes apart, whose axis and points do not show the same gap: by what lies foremost along the axis,
/// nearer points or a better axis or both.
Separation by_foremost(const Core& a, const Core& b, const Separation& told, double slack)
{
    Foremost of_a(a, told.normal), of_b(b, -told.normal);
    const NearestPair pair = nearest_features(of_a, of_b);
    const double distance = std::sqrt(pair.square), enough = distance - slack;
    Axis axis = preferred({told.lower, told.normal}, along(a, b, pair.v), enough);
    for (const Foremost* some : {&of_a, &of_b})
        for (int i = 0; i < some->count; ++i)
            for (int k = 0; k < i && axis.gap < enough; ++k) {
                const V3 n = across(pair.v, some->points[i] - some->points[k]);
                axis = preferred(axis, along(a, b, n), enough);
            }
    if (!(distance < told.gap) && !(axis.gap >= enough))
        return {axis.gap, told.gap, axis.normal, told.point_a, told.point_b};
    const V3 way = axis.gap * axis.normal;
    if (axis.gap < enough || norm(pair.v - way) <= slack)
        return {std::min(axis.gap, distance), distance, axis.normal, pair.point_a, pair.point_a + pair.v};
    // So short a way leads aside: what touches once B is moved along the axis lies at its ends.
    for (int k = 0; k < of_b.count; ++k)
        of_b.points[k] = of_b.points[k] - way;
    const NearestPair rest = nearest_features(of_a, of_b);
    return {axis.gap, axis.gap, axis.normal, rest.point_a, rest.point_a + (way + rest.v)};
}

bool has_round(const Core& a, const Core& b) { return !is_polytope(a) || !is_polytope(b); }

double doubt(const Separation& s) { return s.gap - s.lower; }
double aside(const Separation& s) { return norm(s.point_b - s.point_a - s.gap * s.normal); }

/// Cores apart: what GJK found, and where one is round a better axis, of which GJK knows half of the digits
/// or so.
Separation refined(const Core& a, const Core& b, const Closest& c, const Axis& ahead, double slack)
{
    const double distance = norm(c.v);
    if (!has_round(a, b)) {
        const Axis axis = by_neighbours(a, b, ahead, c, distance - slack);
        return {std::min(axis.gap, distance), distance, axis.normal, c.point_a, c.point_a + c.v};
    }
    const LocalTop top = locally_best(a, b, ahead, slack);
    const bool shorter = norm_squared(top.v) < norm_squared(c.v);
    const double gap = std::max(top.axis.gap, shorter ? norm(top.v) : distance);
    const V3 point_a = shorter ? top.point_a : c.point_a;
    return {top.axis.gap, gap, top.axis.normal, point_a, point_a + gap * top.axis.normal};
}

/// How far a point is from the surface of a core, as far as it is near; NaN for a flat ellipsoid.
double off_surface(const Core& c, V3 p)
{
    using enum Core::Kind;
    const V3 local = into(c.axes, p - c.centre), h = c.half_extents, corner = c.points[0] - p;
    if (c.kind == hull) return c.hull->faces.empty() ? infinity : std::fabs(depth(c, p));
    if (c.kind == box) {
        const double inside = depth(c, p);
        return inside < 0 ? norm(to_box(local, h)) : inside;
    }
    if (c.kind == ellipsoid) { // to first order
        const V3 q{local.x / h.x, local.y / h.y, local.z / h.z};
        return std::fabs(norm(q) - 1) * norm(q) / norm(V3{q.x / h.x, q.y / h.y, q.z / h.z});
    }
    if (c.kind == point) return norm(corner);
    if (c.kind == segment) return norm(to_segment(corner, c.points[1] - p));
    if (c.kind == triangle) return norm(to_triangle(corner, c.points[1] - p, c.points[2] - p));
    return std::fabs(from_point(local, c).gap);
}

/// The point on A that lies together with the one at the end of the way out nearest to both surfaces: that
/// told, or A's or B's foremost, where what grew within the difference has ended short of its surface.
V3 deepest(const Core& a, const Core& b, V3 told, V3 normal, double gap, double slack)
{
    const V3 way = gap * normal;
    V3 best = told;
    double least = infinity;
    for (const V3 candidate : {told, farthest(a, normal).point, farthest(b, -normal).point - way}) {
        const double off = off_surface(a, candidate) + off_surface(b, candidate + way);
        if (off < least) best = candidate, least = off;
        if (least <= tolerance::agreed * slack) break;
    }
    return best;
}

/// Of cores that overlap for certain the gap is the way out that is known to clear them.
Separation with_points(const Core& a, const Core& b, const Penetration& p, double slack)
{
    const bool overlap = p.gap < -slack;
    const double gap = overlap ? p.lower : p.gap;
    const V3 point_a = overlap ? deepest(a, b, p.point_a, p.normal, gap, slack) : p.point_a;
    return {p.lower, gap, p.normal, point_a, point_a + gap * p.normal};
}

/// With points that go from one core's nearest to the other's and back as long as that brings them nearer: of
/// a rim beside a face, or of what all but touches, the others know half of the digits or so.
Separation returned(Core a, Core b, Separation s, double enough)
{
    Core at;
    if (a.kind == at.kind || b.kind == at.kind) return s; // a point stays where it is
    a.radius = b.radius = 0;
    for (int i = 0; i < most_returns && doubt(s) > enough; ++i) {
        at.points[0] = s.point_a;
        const V3 on_b = separation(at, b).point_b;
        at.points[0] = on_b;
        const V3 on_a = separation(a, at).point_a;
        const double distance = norm(on_b - on_a);
        if (!(distance < s.gap)) break;
        s.point_a = on_a;
        s.gap = std::max(s.lower, distance);
        s.point_b = s.point_a + s.gap * s.normal;
    }
    return s;
}

/// Cores of many corners or none, of which GJK was not certain.
Separation by_support(const Core& a, const Core& b, const Closest& c, double slack)
{
    const Axis ahead = along(a, b, c.v);
    const bool apart = ahead.gap > slack;
    const Separation near =
        apart ? refined(a, b, c, ahead, slack) : with_points(a, b, penetration(a, b, slack), slack);
    if (!has_round(a, b)) {
        const bool shown = doubt(near) <= slack && aside(near) <= slack;
        return shown || !(near.lower > slack) ? near : by_foremost(a, b, near, slack);
    }
    if (!apart) return near;
    if (doubt(near) <= tolerance::agreed * slack) return returned(a, b, near, slack);
    const Separation other = with_points(a, b, separation_by_growth(a, b, slack), slack);
    return returned(a, b, other.lower > slack && doubt(other) < doubt(near) ? other : near, slack);
}

} // namespace

Separation polytope_separation(const Core& a, const Core& b)
{
    const double slack = tolerance::tight * std::max(extent(a), extent(b));
    const Closest c = gjk(a, b, {slack});
    if (c.certain)
        return {c.lower, certified(norm(c.v), c.lower, slack), c.normal, c.point_a, c.point_a + c.v};
    if (!is_simple(a) || !is_simple(b)) return by_support(a, b, c, slack);
    const Axis axis = separating_axis(a, b);
    if (axis.gap < -slack) return overlapping(a, b, axis, slack);
    return by_features(a, b, axis, slack);
}

} // namespace brink
