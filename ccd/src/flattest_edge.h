// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_features.h"
#include "segments.h"
#include "support.h"
#include "tolerance.h"

#include <algorithm>

namespace brink {

/// From the corner of a body that lies farthest along an axis to another one.
struct FlatEdge {
    V3 top, along;     // unit, or zero where there is none
    double length = 0; // from there
};

static inline bool has_edges(const Core& c) { return c.count > 1 && c.count <= tolerance::most_corners; }

/// The one that lies as flat as any: an edge, or at least a line inside the body.
static inline FlatEdge flattest_edge(const Core& c, V3 axis)
{
    const V3 top = farthest(c, axis).point;
    FlatEdge edge{top, {}};
    double least = infinity;
    for (int k = 0; k < c.count; ++k) {
        const V3 way = corner(c, k) - top;
        const double length = norm(way), slope = std::fabs(dot(axis, way));
        if (!(length > 0) || slope >= least * length) continue;
        least = slope / length;
        edge.along = (1 / length) * way;
        edge.length = length;
    }
    return edge;
}

static inline bool has_rim(const Core& c)
{
    return c.kind == Core::Kind::cylinder || c.kind == Core::Kind::cone;
}

/// The unit vector across the axis of a cylinder or cone that leads the farthest along another axis.
static inline V3 outwards(const Core& c, V3 axis)
{
    // In its own frame: what rounding leaves where the two axes are parallel is still across.
    const V3 local = into(c.axes, axis);
    const double length = std::sqrt(local.x * local.x + local.y * local.y);
    return length > 0 ? (local.x / length) * c.axes.x + (local.y / length) * c.axes.y : c.axes.x;
}

/// The side of a cylinder or cone that lies flat against an axis, from its rim on.
static inline Segment side(const Core& c, V3 axis)
{
    const V3 up = c.half_extents.z * c.axes.z, out = c.half_extents.x * outwards(c, axis);
    return {c.centre + out - up, c.kind == Core::Kind::cylinder ? 2 * up : 2 * up - out};
}

/// The edges of a body that lie in its supporting plane: one, or some of a face's, or a side of what is
/// round. Without any, a corner stands for them.
struct FlatEdges {
    int count = 0;
    Feature feature[3];
};

static inline FlatEdges edges_across(const Core& body, V3 axis)
{
    FlatEdges edges;
    const auto flat = [&](V3 along) {
        const double length = norm(along);
        if (length > 0 && std::fabs(dot(axis, along)) <= tolerance::flat_edge * length)
            edges.feature[edges.count++] = {Feature::Kind::edge, (1 / length) * along};
    };
    if (has_rim(body)) flat(side(body, axis).edge);
    if (!is_polytope(body)) return edges;
    const int nearest = farthest(body, axis).corner;
    const V3 top = corner(body, nearest);
    for (int k = 0; k < body.count && edges.count < 3; ++k)
        flat(corner(body, k) - top);
    if (body.kind == Core::Kind::triangle && edges.count == 2) {
        const V3 along = body.points[(nearest + 1) % 3] - body.points[(nearest + 2) % 3];
        const double length = norm(along);
        if (length > 0) edges.feature[edges.count++] = {Feature::Kind::edge, (1 / length) * along};
    }
    return edges;
}

/// Where an ellipsoid has a supporting plane at right angles to a unit axis, the tangent along which it is
/// least curved: the larger eigenvector of the second derivative of the supporting height, which in the
/// plane's directions is M - (M n)(M n)' / (n . M n) up to a factor, M with the squares of the radii.
static inline V3 flattest_tangent(const Core& c, V3 axis)
{
    const V3 h = c.half_extents, x = any_perpendicular(axis), y = cross(axis, x);
    const auto stretched = [&](V3 v) {
        const V3 local = into(c.axes, v);
        return V3{h.x * local.x, h.y * local.y, h.z * local.z};
    };
    const V3 p = stretched(x), q = stretched(y), n = stretched(axis);
    const double square = norm_squared(n), inverse = square > 0 ? 1 / square : 0;
    const double xx = norm_squared(p) - dot(p, n) * dot(p, n) * inverse;
    const double yy = norm_squared(q) - dot(q, n) * dot(q, n) * inverse;
    const double xy = dot(p, q) - dot(p, n) * dot(q, n) * inverse, half = 0.5 * (xx - yy);
    const double root = std::sqrt(half * half + xy * xy);
    if (!(root > 0)) return x;
    return half > 0 ? (half + root) * x + xy * y : xy * x + (root - half) * y;
}

/// The lines of a body that lie flat against an axis: the flattest edge, or of what is round those that it is
/// straight along, the tangent of a rim, and two of an ellipsoid. From the point that lies farthest along the
/// axis.
struct FlatLines {
    int count = 0;
    FlatEdge line[2];

    void add(V3 top, V3 way)
    {
        const double length = norm(way);
        if (length > 0) line[count++] = {top, (1 / length) * way, length};
    }
};
static inline FlatLines flat_lines(const Core& c, V3 axis)
{
    using enum Core::Kind;
    FlatLines out;
    if (has_edges(c)) {
        const FlatEdge edge = flattest_edge(c, axis);
        out.add(edge.top, edge.length * edge.along);
        return out;
    }
    if (is_polytope(c)) return out;
    const V3 top = farthest(c, axis).point, h = c.half_extents;
    if (c.kind == ellipsoid) {
        const V3 flattest = flattest_tangent(c, axis);
        out.add(top, flattest);
        out.add(top, cross(axis, flattest));
        return out;
    }
    const V3 across = axis - dot(axis, c.axes.z) * c.axes.z;
    const double length = norm(across);
    if (!(length > 0)) return out;
    const V3 outwards = (h.x / length) * across;
    out.add(top, c.kind == cone ? outwards - (2 * h.z) * c.axes.z : c.axes.z);
    out.add(top, cross(c.axes.z, outwards));
    return out;
}

/// Where the lines of two edges are nearest, as lengths from their tops. They must not be parallel.
struct LinePlaces {
    double on_a, on_b;
};
static inline LinePlaces nearest_places(const FlatEdge& a, const FlatEdge& b)
{
    const V3 product = cross(a.along, b.along), between = b.top - a.top;
    const double square = norm_squared(product);
    return {dot(cross(between, b.along), product) / square, dot(cross(between, a.along), product) / square};
}

} // namespace brink
