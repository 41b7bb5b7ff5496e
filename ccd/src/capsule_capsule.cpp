// SPDX-License-Identifier: BSD-3-Clause
#include "pairs.h"
#include "rounded_polygon.h"
#include "sharp.h"

#include <algorithm>

namespace brink {

namespace {

struct Segment {
    V3 start, edge;
};

double nearest_on(const Segment& s, V3 point) { return nearest_on_edge(s.start, s.edge, point); }

struct Places {
    double on_a, on_b; // 0 to 1
};

/// Turns a point of the parallelogram's face back into a place on each segment. Nearly parallel segments
/// leave a choice; the projections keep their difference right however the first guess came out.
Places places_in_face(V3 met, const Segment& a, const Segment& b, V3 normal)
{
    const V3 q = met - (b.start - a.start);
    const double area_squared = norm_squared(normal);
    const double guess = clamped(dot(cross(a.edge, q), normal) / area_squared);
    const double on_a = nearest_on(a, b.start + guess * b.edge - met);
    if (area_squared > tolerance::nearly_parallel * norm_squared(a.edge) * norm_squared(b.edge))
        return {on_a, guess};
    return {on_a, nearest_on(b, met + a.start + on_a * a.edge)};
}

/// The parallelogram's edges run along b, back along a, back along b, along a.
Places places_on_outline(int edge, V3 met, const Segment& a, const Segment& b)
{
    const bool along_b = edge % 2 == 0;
    const double end = edge == 1 || edge == 2 ? 1 : 0;
    if (along_b) return {end, nearest_on(b, met + a.start + end * a.edge)};
    return {nearest_on(a, b.start + end * b.edge - met), end};
}

} // namespace

/// Two segments meet where their difference, a parallelogram, holds the origin: a moving point against the
/// parallelogram grown by both radii.
Entry capsule_capsule(const Capsule& a, const Capsule& b, const Approach& m)
{
    const Rotation turn_a = m.turn_a(), turn_b = m.turn_b();
    const V3 a0 = turn_a * load(a.a), a1 = turn_a * load(a.b);
    const V3 b0 = turn_b * load(b.a), b1 = turn_b * load(b.b);
    const V3 edge_a = a1 - a0, edge_b = b1 - b0;
    const V3 corner = b0 - a0, opposite = b1 - a1;
    const Polygon difference{{corner, b1 - a0, opposite, b0 - a1}, {edge_b, -edge_a, -edge_b, edge_a},
                             careful_cross(edge_a, edge_b),        0.5 * (corner + opposite),
                             0.5 * (norm(edge_a) + norm(edge_b)),  true};
    const double extents = std::sqrt(std::max(norm_squared(a0), norm_squared(a1))) +
                           std::sqrt(std::max(norm_squared(b0), norm_squared(b1)));
    const Reach r = reach(m, a.radius + b.radius + m.target_gap, extents);
    const PolygonEntry met = polygon_entry(difference, m, r, [&](V3 axis, double t) {
        const Pair radius = two_sum(a.radius, b.radius) + Pair{m.target_gap};
        return sharp::later(a, b, m, axis, radius, r.lengths + extents, t);
    });
    Entry e = met.entry;
    if (!e.meeting) return e;
    Meeting& at = *e.meeting;
    const Places places = met.edge < 0
                              ? places_in_face(at.core_b, {a0, edge_a}, {b0, edge_b}, difference.normal)
                              : places_on_outline(met.edge, at.core_b, {a0, edge_a}, {b0, edge_b});
    at.core_a = at.core_a + a0 + places.on_a * edge_a;
    at.core_b = b0 + places.on_b * edge_b;
    return e;
}

} // namespace brink
