// SPDX-License-Identifier: BSD-3-Clause
#include "feature_pairs.h"

#include "nearest.h"
#include "support.h"

#include <algorithm>
#include <span>

namespace brink {

namespace {

struct Edge {
    int from, to;
};
constexpr Edge box_edges[] = {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3},
                              {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
constexpr Edge triangle_edges[] = {{0, 1}, {1, 2}, {2, 0}};
constexpr Edge segment_edges[] = {{0, 1}};

std::span<const Edge> edges(Core::Kind kind)
{
    switch (kind) {
    case Core::Kind::box:
        return box_edges;
    case Core::Kind::triangle:
        return triangle_edges;
    case Core::Kind::segment:
        return segment_edges;
    default:
        return {};
    }
}

/// From a point to its nearest of a core; zero inside.
V3 to_core(V3 point, const Core& c)
{
    const V3 p = c.points[0] - point, q = c.points[1] - point, r = c.points[2] - point;
    switch (c.kind) {
    case Core::Kind::segment:
        return to_segment(p, q);
    case Core::Kind::triangle:
        return to_triangle(p, q, r);
    case Core::Kind::box:
        return c.axes * to_box(into(c.axes, point - c.centre), c.half_extents);
    default:
        return p;
    }
}

bool has(const Patch& p, int corner) { return (p.corners >> corner & 1U) != 0; }

NearestPair nearer(const NearestPair& best, V3 point_a, V3 v)
{
    const double square = norm_squared(v);
    return square < best.square ? NearestPair{square, point_a, v} : best;
}

NearestPair nearest_edges(const Patch& a, const Patch& b, NearestPair best)
{
    for (const Edge e : edges(a.core.kind)) {
        if (!has(a, e.from) || !has(a, e.to)) continue;
        const V3 p = corner(a.core, e.from), d = corner(a.core, e.to) - p;
        for (const Edge f : edges(b.core.kind)) {
            if (!has(b, f.from) || !has(b, f.to)) continue;
            const V3 q = corner(b.core, f.from), g = corner(b.core, f.to) - q, r = q - p;
            const auto [s, t] = nearest_parameters(r, d, g);
            best = nearer(best, p + s * d, r + t * g - s * d);
        }
    }
    return best;
}

} // namespace

NearestPair nearest_features(const Patch& a, const Patch& b)
{
    NearestPair best;
    for (int k = 0; k < a.core.count; ++k) {
        if (!has(a, k)) continue;
        const V3 point = corner(a.core, k);
        best = nearer(best, point, to_core(point, b.core));
    }
    for (int k = 0; k < b.core.count; ++k) {
        if (!has(b, k)) continue;
        const V3 point = corner(b.core, k), v = to_core(point, a.core);
        best = nearer(best, point + v, -v);
    }
    return nearest_edges(a, b, best);
}

} // namespace brink
