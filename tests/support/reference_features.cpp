// SPDX-License-Identifier: BSD-3-Clause
#include "reference_features.h"

#include <algorithm>
#include <optional>
#include <span>

namespace brink::support {
namespace {

using Kind = Placed::Kind;

struct Edge {
    Real3 from, to;
};

struct Edges {
    std::array<Edge, 12> edge;
    std::size_t count = 0;
    std::span<const Edge> all() const& { return {edge.data(), count}; }
    std::span<const Edge> all() const&& = delete; // it would outlive the edges
};

/// A point counts as one edge of no length, so that edges alone reach every corner.
Edges edges(const Placed& s)
{
    Edges out;
    const auto add = [&](std::size_t i, std::size_t j) {
        out.edge[out.count++] = {s.corners[i], s.corners[j]};
    };
    if (s.kind == Kind::point) add(0, 0);
    if (s.kind == Kind::segment) add(0, 1);
    if (s.kind == Kind::triangle) {
        add(0, 1);
        add(1, 2);
        add(2, 0);
    }
    if (s.kind != Kind::box) return out;
    for (std::size_t i = 0; i < 8; ++i)
        for (std::size_t bit = 1; bit < 8; bit *= 2)
            if ((i & bit) == 0) add(i, i | bit);
    return out;
}

std::span<const Real3> corners(const Placed& s) { return {s.corners.data(), s.corner_count}; }

Real3 nearest_on_edge(const Edge& e, const Real3& p)
{
    const Real3 u = e.to - e.from;
    const Real uu = dot(u, u);
    if (!(uu > 0)) return e.from;
    const Real s = dot(p - e.from, u) / uu;
    if (s <= 0) return e.from;
    if (s >= 1) return e.to;
    return e.from + s * u;
}

/// Nearest points of two edges where neither is an end point, if there are such.
std::optional<Nearest> nearest_inside_edges(const Edge& a, const Edge& b)
{
    const Real3 u = a.to - a.from;
    const Real3 v = b.to - b.from;
    const Real3 n = cross(u, v);
    const Real nn = dot(n, n);
    if (!(nn > 0)) return std::nullopt;
    const Real s = dot(cross(b.from - a.from, v), n) / nn;
    if (s < 0 || s > 1) return std::nullopt;
    // Near-parallel edges: s carries noise, so the point of b is taken nearest to the point at s.
    const Real3 on_a = a.from + s * u;
    Nearest best;
    best.keep(on_a, nearest_on_edge(b, on_a));
    return best;
}

/// The foot of p on the triangle's plane, where that lies inside. It is a mean of the corners, so that it
/// lies in the triangle however thin that is.
std::optional<Real3> foot_on_triangle(const Placed& s, const Real3& p)
{
    const Real3 u = s.corners[1] - s.corners[0];
    const Real3 v = s.corners[2] - s.corners[0];
    const Real3 w = p - s.corners[0];
    const Real3 n = cross(u, v);
    const Real nn = dot(n, n);
    if (!(nn > 0)) return std::nullopt;
    const Real along_u = dot(cross(w, v), n) / nn;
    const Real along_v = dot(cross(u, w), n) / nn;
    if (along_u < 0 || along_v < 0 || along_u + along_v > 1) return std::nullopt;
    return s.corners[0] + along_u * u + along_v * v;
}

Real3 in_box_frame(const Placed& box, const Real3& p) { return transposed_times(box.axes, p - box.centre); }

Real3 nearest_in_box(const Placed& box, const Real3& p)
{
    const Real3 q = in_box_frame(box, p);
    const Real3 near{std::clamp(q.x, -box.half.x, box.half.x), std::clamp(q.y, -box.half.y, box.half.y),
                     std::clamp(q.z, -box.half.z, box.half.z)};
    return box.centre + box.axes * near;
}

/// Nearest point of the core to p.
Real3 nearest_in_core(const Placed& s, const Real3& p)
{
    if (s.kind == Kind::point) return s.corners[0];
    if (s.kind == Kind::segment) return nearest_on_edge({s.corners[0], s.corners[1]}, p);
    if (s.kind == Kind::box) return nearest_in_box(s, p);
    Nearest best;
    if (const auto foot = foot_on_triangle(s, p)) best.keep(p, *foot);
    const Edges around = edges(s);
    for (const Edge& e : around.all())
        best.keep(p, nearest_on_edge(e, p));
    return best.on_b;
}

bool edge_meets_box(const Edge& e, const Placed& box)
{
    const Real3 from = in_box_frame(box, e.from);
    const Real3 to = in_box_frame(box, e.to);
    const std::array<std::array<Real, 3>, 3> slabs{
        {{from.x, to.x, box.half.x}, {from.y, to.y, box.half.y}, {from.z, to.z, box.half.z}}};
    Real enter = 0;
    Real leave = 1;
    for (const auto& [p, q, half] : slabs) {
        const Real d = q - p;
        if (d == 0) {
            if (std::abs(p) > half) return false;
            continue;
        }
        const Real s = (-half - p) / d;
        const Real t = (half - p) / d;
        enter = std::max(enter, std::min(s, t));
        leave = std::min(leave, std::max(s, t));
    }
    return enter <= leave;
}

bool edge_pierces_triangle(const Edge& e, const Placed& s)
{
    const Real3& a = s.corners[0];
    const Real3 n = cross(s.corners[1] - a, s.corners[2] - a);
    const Real from = dot(e.from - a, n);
    const Real to = dot(e.to - a, n);
    if ((from > 0) == (to > 0) || from == to) return false;
    return foot_on_triangle(s, e.from + (from / (from - to)) * (e.to - e.from)).has_value();
}

bool any_edge_meets(const Edges& edges, const Placed& s)
{
    if (s.kind != Kind::box && s.kind != Kind::triangle) return false;
    return std::any_of(edges.all().begin(), edges.all().end(), [&](const Edge& e) {
        return s.kind == Kind::box ? edge_meets_box(e, s) : edge_pierces_triangle(e, s);
    });
}

/// Directions of the distinct edges, and the normals of the faces.
struct Directions {
    std::array<Real3, 3> edge, face;
    std::size_t edges = 0, faces = 0;
};

Directions directions(const Placed& s)
{
    const auto& c = s.corners;
    const Real3 u = c[1] - c[0];
    if (s.kind == Kind::segment) return {{u}, {}, 1, 0};
    if (s.kind == Kind::box) return {{s.axes.x, s.axes.y, s.axes.z}, {s.axes.x, s.axes.y, s.axes.z}, 3, 3};
    if (s.kind == Kind::triangle) return {{u, c[2] - c[1], c[0] - c[2]}, {cross(u, c[2] - c[0])}, 3, 1};
    return {};
}

/// How far the corners reach along n, from `origin`.
std::array<Real, 2> extent(const Placed& s, const Real3& n, const Real3& origin)
{
    Real low = std::numeric_limits<Real>::infinity();
    Real high = -low;
    for (const Real3& p : corners(s)) {
        const Real along = dot(n, p - origin);
        low = std::min(low, along);
        high = std::max(high, along);
    }
    return {low, high};
}

Separation along_axis(const Placed& a, const Placed& b, const Real3& axis)
{
    const Real3 n = direction(axis);
    if (n.x == 0 && n.y == 0 && n.z == 0) return {};
    const auto [low_a, high_a] = extent(a, n, a.corners[0]);
    const auto [low_b, high_b] = extent(b, n, a.corners[0]);
    if (low_b - high_a >= low_a - high_b) return {low_b - high_a, n};
    return {low_a - high_b, -n};
}

} // namespace

Nearest nearest_features(const Placed& a, const Placed& b)
{
    Nearest best;
    for (const Real3& p : corners(a))
        best.keep(p, nearest_in_core(b, p));
    for (const Real3& p : corners(b))
        best.keep(nearest_in_core(a, p), p);
    if (a.kind == Kind::point || b.kind == Kind::point) return best;
    const Edges edges_a = edges(a);
    const Edges edges_b = edges(b);
    for (const Edge& ea : edges_a.all())
        for (const Edge& eb : edges_b.all())
            if (const auto near = nearest_inside_edges(ea, eb)) best.keep(near->on_a, near->on_b);
    return best;
}

bool cores_meet(const Placed& a, const Placed& b)
{
    return any_edge_meets(edges(a), b) || any_edge_meets(edges(b), a);
}

Separation separating_axes(const Placed& a, const Placed& b)
{
    const Directions da = directions(a);
    const Directions db = directions(b);
    Separation best;
    const auto keep = [&](const Real3& axis) {
        const Separation found = along_axis(a, b, axis);
        if (found.along > best.along) best = found;
    };
    for (std::size_t i = 0; i < da.faces; ++i)
        keep(da.face[i]);
    for (std::size_t i = 0; i < db.faces; ++i)
        keep(db.face[i]);
    for (std::size_t i = 0; i < da.edges; ++i)
        for (std::size_t j = 0; j < db.edges; ++j)
            keep(cross(da.edge[i], db.edge[j]));
    return best;
}

} // namespace brink::support
