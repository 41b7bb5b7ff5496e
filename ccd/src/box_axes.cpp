// SPDX-License-Identifier: BSD-3-Clause
#include "box_axes.h"

#include "lanes.h"
#include "nearest.h"
#include "support.h"
#include "tolerance.h"

namespace brink {

namespace {

struct Cosines {
    double of[3][3]; // A's axis i with B's axis j
    double size[3][3];
};

/// The best axis so far: 0 to 2 a face of A, 3 to 5 a face of B, then edges 6 + 3 i + j.
struct Best {
    double gap = -infinity;
    int index = 0;
    double side = 1; // of the centre of B
};

struct Boxes {
    double ha[3], hb[3];
    double from[3]; // B's centre from A's, in A's frame
    Cosines c;
};

Boxes boxes(const Core& a, const Core& b)
{
    Boxes s{{a.half_extents.x, a.half_extents.y, a.half_extents.z},
            {b.half_extents.x, b.half_extents.y, b.half_extents.z},
            {},
            {}};
    const V3 of_a[3] = {a.axes.x, a.axes.y, a.axes.z}, of_b[3] = {b.axes.x, b.axes.y, b.axes.z};
    const V3 offset = b.centre - a.centre;
    for (int i = 0; i < 3; ++i) {
        s.from[i] = dot(of_a[i], offset);
        for (int j = 0; j < 3; ++j) {
            s.c.of[i][j] = dot(of_a[i], of_b[j]);
            s.c.size[i][j] = std::fabs(s.c.of[i][j]);
        }
    }
    return s;
}

void try_faces(const Boxes& s, Best& best)
{
    for (int k = 0; k < 3; ++k) {
        const double* row = s.c.size[k];
        const double gap =
            std::fabs(s.from[k]) - (s.ha[k] + (s.hb[0] * row[0] + s.hb[1] * row[1] + s.hb[2] * row[2]));
        if (gap > best.gap) best = {gap, k, s.from[k]};
    }
    for (int k = 0; k < 3; ++k) {
        const double from = s.from[0] * s.c.of[0][k] + s.from[1] * s.c.of[1][k] + s.from[2] * s.c.of[2][k];
        const double reach = s.ha[0] * s.c.size[0][k] + s.ha[1] * s.c.size[1][k] + s.ha[2] * s.c.size[2][k];
        const double gap = std::fabs(from) - (s.hb[k] + reach);
        if (gap > best.gap) best = {gap, 3 + k, from};
    }
}

void try_edges(const Boxes& s, Best& best)
{
    constexpr int next[3] = {1, 2, 0}, last[3] = {2, 0, 1};
    double least = best.gap * std::fabs(best.gap); // what squares are compared with
    for (int i = 0; i < 3; ++i) {
        const int i1 = next[i], i2 = last[i];
        for (int j = 0; j < 3; ++j) {
            const double square = 1 - s.c.of[i][j] * s.c.of[i][j];
            const double from = s.from[i2] * s.c.of[i1][j] - s.from[i1] * s.c.of[i2][j];
            const double reach =
                (s.ha[i1] * s.c.size[i2][j] + s.ha[i2] * s.c.size[i1][j]) +
                (s.hb[next[j]] * s.c.size[i][last[j]] + s.hb[last[j]] * s.c.size[i][next[j]]);
            const double longer = std::fabs(from) - reach;             // the gap times the sine
            if (longer * std::fabs(longer) < least * square) continue; // by far the most
            if (square < tolerance::nearly_parallel) continue;
            if (best.gap > 0 ? longer <= 0 || longer * longer <= best.gap * best.gap * square
                             : longer < 0 && longer * longer >= best.gap * best.gap * square)
                continue;
            best = {longer / std::sqrt(square), 6 + 3 * i + j, from};
            least = best.gap * std::fabs(best.gap);
        }
    }
}

V3 axis(const Core& c, int k) { return k == 0 ? c.axes.x : k == 1 ? c.axes.y : c.axes.z; }

V3 facing(V3 n, double side) { return side < 0 ? -n : n; }

/// The edge of a box along its axis k that lies farthest along d.
struct Edge {
    V3 from, by;
};
Edge edge_towards(const Core& c, int k, V3 d)
{
    constexpr double side[2] = {-1, 1};
    const V3 h = c.half_extents, up = into(c.axes, d);
    const int top =
        static_cast<int>(up.x > 0) + 2 * static_cast<int>(up.y > 0) + 4 * static_cast<int>(up.z > 0);
    const int from = top & ~(1 << k), to = top | 1 << k;
    const auto ends = [&](int axis) { return Two{side[from >> axis & 1], side[to >> axis & 1]}; };
    const XYZ<Two> on_x = both(c.centre) + ends(0) * both(h.x) * both(c.axes.x);
    const XYZ<Two> on_y = on_x + ends(1) * both(h.y) * both(c.axes.y);
    const XYZ<Two> corners = on_y + ends(2) * both(h.z) * both(c.axes.z);
    return {first(corners), second(corners) - first(corners)};
}

BoxWitness over_face(const Core& box, V3 point)
{
    const V3 v = box.axes * to_box(into(box.axes, point - box.centre), box.half_extents);
    return {point, v};
}

} // namespace

BoxAxis box_axis(const Core& a, const Core& b)
{
    const Boxes s = boxes(a, b);
    Best best;
    try_faces(s, best);
    try_edges(s, best);
    if (best.index < 3) return {best.gap, facing(axis(a, best.index), best.side), best.index};
    if (best.index < 6) return {best.gap, facing(axis(b, best.index - 3), best.side), best.index};
    const V3 n = cross(axis(a, (best.index - 6) / 3), axis(b, (best.index - 6) % 3));
    return {best.gap, facing((1 / norm(n)) * n, best.side), best.index};
}

Features box_features(const Core& a, const Core& b, int index)
{
    using enum Feature::Kind;
    if (index < 3) return {{face, axis(a, index)}, {}};
    if (index < 6) return {{}, {face, axis(b, index - 3)}};
    return {{edge, axis(a, (index - 6) / 3)}, {edge, axis(b, (index - 6) % 3)}};
}

BoxWitness box_witness(const Core& a, const Core& b, int index, V3 normal)
{
    if (index < 3) {
        const BoxWitness w = over_face(a, farthest(b, -normal).point);
        return {w.point_a + w.v, -w.v};
    }
    if (index < 6) return over_face(b, farthest(a, normal).point);
    const Edge d = edge_towards(a, (index - 6) / 3, normal);
    const Edge e = edge_towards(b, (index - 6) % 3, -normal);
    const V3 r = e.from - d.from;
    const auto [s, t] = nearest_parameters(r, d.by, e.by);
    return {d.from + s * d.by, r + t * e.by - s * d.by};
}

} // namespace brink
