// SPDX-License-Identifier: BSD-3-Clause
#include "box_axes.h"

#include "lanes.h"
#include "nearest.h"
#include "support.h"
#include "tolerance.h"

namespace brink {

namespace {

/// Three numbers, one for each axis of a box; beside the third may stand anything.
struct Three {
    Two of_xy, of_z;
};
Three operator*(double s, Three t) { return {both(s) * t.of_xy, both(s) * t.of_z}; }
Three operator*(Three s, Three t) { return {s.of_xy * t.of_xy, s.of_z * t.of_z}; }
Three operator+(Three s, Three t) { return {s.of_xy + t.of_xy, s.of_z + t.of_z}; }
Three operator-(Three s, Three t) { return {s.of_xy - t.of_xy, s.of_z - t.of_z}; }
Three sizes(Three t) { return {magnitude(t.of_xy), magnitude(t.of_z)}; }

/// Axes of one kind, two by two: which is the best can hardly be predicted, so no branch asks. Beside an odd
/// last one stands its copy.
template <int pairs> struct Axes {
    Two gap[pairs];  // of edges its square, with its sign
    Two from[pairs]; // the centre of B along it

    int best() const
    {
        Two most = both(-infinity), at{}, place{0, 1};
        for (const Two here : gap) {
            at = select(here > most, place, at);
            most = larger(here, most);
            place = place + both(2);
        }
        return static_cast<int>(select(both(most[1]) > most, both(at[1]), at)[0]);
    }
};

struct Relative {
    double ha[3], hb[3];
    double from[3];             // B's centre from A's, in A's frame
    Three cosines[3], sizes[3]; // of A's axis i with B's axes
};

Relative relative(const Core& a, const Core& b)
{
    const V3 ha = a.half_extents, hb = b.half_extents;
    Relative s{{ha.x, ha.y, ha.z}, {hb.x, hb.y, hb.z}, {}, {}, {}};
    const V3 of_a[3] = {a.axes.x, a.axes.y, a.axes.z};
    const XYZ<Two> xy = pair(b.axes.x, b.axes.y), z_and_offset = pair(b.axes.z, b.centre - a.centre);
    for (int i = 0; i < 3; ++i) {
        s.cosines[i] = {dot(both(of_a[i]), xy), dot(both(of_a[i]), z_and_offset)};
        s.from[i] = s.cosines[i].of_z[1];
        s.sizes[i] = sizes(s.cosines[i]);
    }
    return s;
}

/// 0 to 2 those of A, 3 to 5 those of B.
Axes<3> faces(const Relative& s)
{
    const Three &x = s.sizes[0], &y = s.sizes[1], &z = s.sizes[2];
    const Two reach_xy = both(s.hb[0]) * Two{x.of_xy[0], y.of_xy[0]} +
                         both(s.hb[1]) * Two{x.of_xy[1], y.of_xy[1]} +
                         both(s.hb[2]) * Two{x.of_z[0], y.of_z[0]};
    const double reach_z = s.hb[0] * z.of_xy[0] + s.hb[1] * z.of_xy[1] + s.hb[2] * z.of_z[0];
    const Two from_xy{s.from[0], s.from[1]};
    const Two gap_xy = magnitude(from_xy) - (Two{s.ha[0], s.ha[1]} + reach_xy);
    const double gap_z = std::fabs(s.from[2]) - (s.ha[2] + reach_z);

    const Three from = s.from[0] * s.cosines[0] + s.from[1] * s.cosines[1] + s.from[2] * s.cosines[2];
    const Three reach = s.ha[0] * x + s.ha[1] * y + s.ha[2] * z;
    const Three gap = sizes(from) - (Three{{s.hb[0], s.hb[1]}, both(s.hb[2])} + reach);
    return {{gap_xy, Two{gap_z, gap.of_xy[0]}, Two{gap.of_xy[1], gap.of_z[0]}},
            {from_xy, Two{s.from[2], from.of_xy[0]}, Two{from.of_xy[1], from.of_z[0]}}};
}

/// Rows of three in their order, two by two.
void put(const Three* rows, Two* out)
{
    out[0] = rows[0].of_xy;
    out[1] = Two{rows[0].of_z[0], rows[1].of_xy[0]};
    out[2] = Two{rows[1].of_xy[1], rows[1].of_z[0]};
    out[3] = rows[2].of_xy;
    out[4] = both(rows[2].of_z[0]);
}

/// 3 i + j for A's edge i and B's edge j, but those that are nearly parallel.
Axes<5> edges(const Relative& s)
{
    constexpr int next[3] = {1, 2, 0}, last[3] = {2, 0, 1};
    const Two hb_yz{s.hb[1], s.hb[2]}, hb_zx{s.hb[2], s.hb[0]};
    Three from[3], longer[3], square[3]; // the gap times the sine, and its square
    for (int i = 0; i < 3; ++i) {
        const int i1 = next[i], i2 = last[i];
        const Three& size = s.sizes[i];
        const Three of_a = s.ha[i1] * s.sizes[i2] + s.ha[i2] * s.sizes[i1];
        const Three of_b{hb_yz * Two{size.of_z[0], size.of_xy[0]} + hb_zx * Two{size.of_xy[1], size.of_z[0]},
                         both(s.hb[0] * size.of_xy[1] + s.hb[1] * size.of_xy[0])};
        from[i] = s.from[i2] * s.cosines[i1] - s.from[i1] * s.cosines[i2];
        longer[i] = sizes(from[i]) - (of_a + of_b);
        square[i] = Three{both(1), both(1)} - s.cosines[i] * s.cosines[i];
    }
    Axes<5> out;
    Two sines[5];
    put(from, out.from);
    put(longer, out.gap);
    put(square, sines);
    for (int k = 0; k < 5; ++k) {
        const TwoFlags known = sines[k] >= both(tolerance::nearly_parallel);
        out.gap[k] = select(known, out.gap[k] * magnitude(out.gap[k]) / sines[k], both(-infinity));
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
    const Axes<3> of_faces = faces(s);
    const Axes<5> of_edges = edges(s);
    const int k = of_faces.best(), e = of_edges.best();
    const double gap = of_faces.gap[k / 2][k % 2], square = of_edges.gap[e / 2][e % 2];
    if (!(square > gap * std::fabs(gap)))
        return {gap, facing(k < 3 ? axis(a, k) : axis(b, k - 3), of_faces.from[k / 2][k % 2]), k};
    const V3 n = cross(axis(a, e / 3), axis(b, e % 3));
    const double root = std::sqrt(std::fabs(square));
    return {square < 0 ? -root : root, facing((1 / norm(n)) * n, of_edges.from[e / 2][e % 2]), 6 + e};
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
