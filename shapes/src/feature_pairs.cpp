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

const NearestPair& nearer(const NearestPair& best, const NearestPair& other)
{
    return other.square < best.square ? other : best;
}

NearestPair between(V3 point_a, V3 v) { return {norm_squared(v), point_a, v}; }

/// Of the segments from p to p_end and from q to q_end.
NearestPair between_segments(V3 p, V3 p_end, V3 q, V3 q_end)
{
    const V3 d = p_end - p, g = q_end - q, r = q - p;
    const auto [s, t] = nearest_parameters(r, d, g);
    return between(p + s * d, r + t * g - s * d);
}

NearestPair nearest_edges(const Patch& a, const Patch& b, NearestPair best)
{
    for (const Edge e : edges(a.core.kind)) {
        if (!has(a, e.from) || !has(a, e.to)) continue;
        const V3 p = corner(a.core, e.from), p_end = corner(a.core, e.to);
        for (const Edge f : edges(b.core.kind)) {
            if (!has(b, f.from) || !has(b, f.to)) continue;
            best = nearer(best, between_segments(p, p_end, corner(b.core, f.from), corner(b.core, f.to)));
        }
    }
    return best;
}

/// Does something with every three of the points, fewer where there are no three.
template <class Do> void for_each_triangle(const Foremost& of, const Do& go)
{
    const V3* p = of.points;
    if (of.count < 3) go(p[0], p[of.count - 1], p[of.count - 1]);
    for (int i = 0; i < of.count; ++i)
        for (int k = i + 1; k < of.count; ++k)
            for (int m = k + 1; m < of.count; ++m)
                go(p[i], p[k], p[m]);
}
/// The same with every two.
template <class Do> void for_each_segment(const Foremost& of, const Do& go)
{
    for (int i = 0; i < of.count; ++i)
        for (int k = i + 1; k < of.count; ++k)
            go(of.points[i], of.points[k]);
}

} // namespace

NearestPair nearest_features(const Patch& a, const Patch& b)
{
    NearestPair best;
    for (int k = 0; k < a.core.count; ++k) {
        if (!has(a, k)) continue;
        const V3 point = corner(a.core, k);
        best = nearer(best, between(point, to_core(point, b.core)));
    }
    for (int k = 0; k < b.core.count; ++k) {
        if (!has(b, k)) continue;
        const V3 point = corner(b.core, k), v = to_core(point, a.core);
        best = nearer(best, between(point + v, -v));
    }
    return nearest_edges(a, b, best);
}

Foremost::Foremost(const Core& c, V3 n)
{
    double heights[most];
    for (int k = 0; k < c.count; ++k) {
        const V3 point = corner(c, k);
        const double height = dot(n, point);
        if (count == most && !(height > heights[most - 1])) continue;
        if (count < most) ++count;
        int place = count - 1;
        for (; place > 0 && height > heights[place - 1]; --place) {
            heights[place] = heights[place - 1];
            points[place] = points[place - 1];
        }
        heights[place] = height;
        points[place] = point;
    }
}

NearestPair nearest_features(const Foremost& a, const Foremost& b)
{
    NearestPair best;
    for_each_triangle(b, [&](V3 p, V3 q, V3 r) {
        for (int i = 0; i < a.count; ++i) {
            const V3 point = a.points[i];
            best = nearer(best, between(point, to_triangle(p - point, q - point, r - point)));
        }
    });
    for_each_triangle(a, [&](V3 p, V3 q, V3 r) {
        for (int i = 0; i < b.count; ++i) {
            const V3 point = b.points[i], v = to_triangle(p - point, q - point, r - point);
            best = nearer(best, between(point + v, -v));
        }
    });
    for_each_segment(a, [&](V3 p, V3 p_end) {
        for_each_segment(b,
                         [&](V3 q, V3 q_end) { best = nearer(best, between_segments(p, p_end, q, q_end)); });
    });
    return best;
}

} // namespace brink
