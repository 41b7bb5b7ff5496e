// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
