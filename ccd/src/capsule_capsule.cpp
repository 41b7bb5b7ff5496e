// SPDX-License-Identifier: BSD-3-Clause
#include "pairs.h"
#include "rounded_polygon.h"

namespace brink {

namespace {

struct Segment {
    V3 start, edge;
};

double clamped(double s) { return s < 0 ? 0 : s > 1 ? 1 : s; }

/// Where on the segment, 0 to 1, `point` comes nearest.
double nearest_on(const Segment& s, V3 point)
{
    const double length_squared = norm_squared(s.edge);
    return length_squared == 0 ? 0 : clamped(dot(point - s.start, s.edge) / length_squared);
}

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
Places places_on_outline(int edge, double along)
{
    switch (edge) {
    case 0:
        return {0, along};
    case 1:
        return {along, 1};
    case 2:
        return {1, 1 - along};
    default:
        return {1 - along, 0};
    }
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
    const Polygon difference{{corner, b1 - a0, opposite, b0 - a1},
                             careful_cross(edge_a, edge_b),
                             0.5 * (corner + opposite),
                             0.5 * (norm(edge_a) + norm(edge_b))};
    const PolygonEntry met = polygon_entry(difference, m.from, m.by, a.radius + b.radius + m.target_gap);
    Entry e = met.entry;
    if (e.t == 0 || e.t == infinity) return e;
    const Places places = met.edge < 0
                              ? places_in_face(e.core_b, {a0, edge_a}, {b0, edge_b}, difference.normal)
                              : places_on_outline(met.edge, met.along);
    e.core_a = e.core_a + a0 + places.on_a * edge_a;
    e.core_b = b0 + places.on_b * edge_b;
    return e;
}

} // namespace brink
