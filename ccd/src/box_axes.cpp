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

/// Axes of one kind, side by side: which is the best can hardly be predicted, so no branch asks. Past the
/// last one nothing is larger than another.
template <int n> struct Axes {
    double gap[n];  // of edges its square, with its sign
    double from[n]; // the centre of B along it

    int best() const
    {
        Two most = both(-infinity), at{};
        for (int k = 0; k < n; k += 2) {
            const Two here = load_two(&gap[k]), place{static_cast<double>(k), static_cast<double>(k + 1)};
            at = select(here > most, place, at);
            most = larger(here, most);
        }
        return static_cast<int>(select(both(most[1]) > most, both(at[1]), at)[0]);
    }
};

struct Relative {
    double ha[3], hb[3];
    double from[3]; // B's centre from A's, in A's frame
    Cosines c;
};

Relative relative(const Core& a, const Core& b)
{
    Relative s{{a.half_extents.x, a.half_extents.y, a.half_extents.z},
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

/// 0 to 2 those of A, 3 to 5 those of B.
Axes<6> faces(const Relative& s)
{
    Axes<6> out;
    for (int k = 0; k < 3; ++k) {
        const double* row = s.c.size[k];
        out.from[k] = s.from[k];
        out.gap[k] =
            std::fabs(s.from[k]) - (s.ha[k] + (s.hb[0] * row[0] + s.hb[1] * row[1] + s.hb[2] * row[2]));
    }
    for (int k = 0; k < 3; ++k) {
        const double from = s.from[0] * s.c.of[0][k] + s.from[1] * s.c.of[1][k] + s.from[2] * s.c.of[2][k];
        const double reach = s.ha[0] * s.c.size[0][k] + s.ha[1] * s.c.size[1][k] + s.ha[2] * s.c.size[2][k];
        out.from[3 + k] = from;
        out.gap[3 + k] = std::fabs(from) - (s.hb[k] + reach);
    }
    return out;
}

/// 3 i + j for A's edge i and B's edge j, but those that are nearly parallel.
Axes<10> edges(const Relative& s)
{
    constexpr int next[3] = {1, 2, 0}, last[3] = {2, 0, 1};
    Axes<10> out;
    double square[10]; // of the sine
    for (int i = 0; i < 3; ++i) {
        const int i1 = next[i], i2 = last[i];
        for (int j = 0; j < 3; ++j) {
            const double from = s.from[i2] * s.c.of[i1][j] - s.from[i1] * s.c.of[i2][j];
            const double reach =
                (s.ha[i1] * s.c.size[i2][j] + s.ha[i2] * s.c.size[i1][j]) +
                (s.hb[next[j]] * s.c.size[i][last[j]] + s.hb[last[j]] * s.c.size[i][next[j]]);
            square[3 * i + j] = 1 - s.c.of[i][j] * s.c.of[i][j];
            out.from[3 * i + j] = from;
            out.gap[3 * i + j] = std::fabs(from) - reach; // the gap times the sine
        }
    }
    square[9] = 0;
    out.gap[9] = 0;
    for (int k = 0; k < 10; k += 2) {
        const Two longer = load_two(&out.gap[k]), sines = load_two(&square[k]);
        const TwoFlags known = sines >= both(tolerance::nearly_parallel);
        const Two squares = select(known, longer * magnitude(longer) / sines, both(-infinity));
        out.gap[k] = squares[0];
        out.gap[k + 1] = squares[1];
    }
    return out;
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
    const Relative s = relative(a, b);
    const Axes<6> of_faces = faces(s);
    const Axes<10> of_edges = edges(s);
    const int k = of_faces.best(), e = of_edges.best();
    const double gap = of_faces.gap[k], square = of_edges.gap[e];
    if (!(square > gap * std::fabs(gap)))
        return {gap, facing(k < 3 ? axis(a, k) : axis(b, k - 3), of_faces.from[k]), k};
    const V3 n = cross(axis(a, e / 3), axis(b, e % 3));
    const double root = std::sqrt(std::fabs(square));
    return {square < 0 ? -root : root, facing((1 / norm(n)) * n, of_edges.from[e]), 6 + e};
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
