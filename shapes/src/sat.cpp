// SPDX-License-Identifier: BSD-3-Clause
#include "sat.h"

#include "nearest.h"
#include "support.h"

namespace brink {

namespace {

/// The better of `best` and the direction n in either sense, if it has a length.
Axis better(const Core& a, const Core& b, const Axis& best, V3 n)
{
    const double length = norm(n);
    if (!(length > 0)) return best;
    n = (1 / length) * n;
    const Interval of_a = interval(a, n), of_b = interval(b, n);
    const double ahead = of_b.low - of_a.high, behind = of_a.low - of_b.high;
    if (ahead >= behind) return ahead > best.gap ? Axis{ahead, n} : best;
    return behind > best.gap ? Axis{behind, -n} : best;
}

V3 longest_edge(const Directions& a, const Directions& b)
{
    V3 longest;
    for (int k = 0; k < a.edges; ++k)
        if (norm_squared(a.edge[k]) > norm_squared(longest)) longest = a.edge[k];
    for (int k = 0; k < b.edges; ++k)
        if (norm_squared(b.edge[k]) > norm_squared(longest)) longest = b.edge[k];
    return longest;
}

Directions with_edge(Directions d, V3 edge)
{
    if (!(edge == V3{})) d.edge[d.edges++] = edge;
    return d;
}

} // namespace

Directions directions(const Core& c)
{
    Directions d;
    if (c.kind == Core::Kind::box) {
        d.faces = 3;
        d.face[0] = c.axes.x, d.face[1] = c.axes.y, d.face[2] = c.axes.z;
        d = with_edge(d, c.half_extents.x * c.axes.x);
        d = with_edge(d, c.half_extents.y * c.axes.y);
        d = with_edge(d, c.half_extents.z * c.axes.z);
    } else if (c.kind == Core::Kind::triangle) {
        for (int k = 0; k < 3; ++k)
            d = with_edge(d, c.points[(k + 1) % 3] - c.points[k]);
        d.face[0] = face_normal(c.points[0], c.points[1], c.points[2]);
        d.faces = d.face[0] == V3{} ? 0 : 1;
    } else if (c.kind == Core::Kind::segment) {
        d = with_edge(d, c.points[1] - c.points[0]);
    }
    return d;
}

Axis separating_axis(const Core& a, const Core& b)
{
    const Directions of_a = directions(a), of_b = directions(b);
    Axis best;
    for (int k = 0; k < of_a.faces; ++k)
        best = better(a, b, best, of_a.face[k]);
    for (int k = 0; k < of_b.faces; ++k)
        best = better(a, b, best, of_b.face[k]);
    for (int i = 0; i < of_a.edges; ++i)
        for (int j = 0; j < of_b.edges; ++j)
            best = better(a, b, best, common_normal(of_a.edge[i], of_b.edge[j]));
    // All may lie in one line, or in one point: any direction across it will do.
    if (of_a.faces == 0 || of_b.faces == 0)
        best = better(a, b, best, any_perpendicular(longest_edge(of_a, of_b)));
    return best;
}

} // namespace brink
