// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rounded_polygon.h"

/// Two segments meet where their difference, a parallelogram, holds the origin: a moving point against the
/// parallelogram grown by a radius.
namespace brink {

struct Segment {
    V3 start, edge;

    V3 end() const { return start + edge; }
};

static inline double nearest_on(const Segment& s, V3 point)
{
    return nearest_on_edge(s.start, s.edge, point);
}

struct Places {
    double on_a, on_b; // 0 to 1
};

/// Turns a point of the parallelogram's face back into a place on each segment. Nearly parallel segments
/// leave a choice; the projections keep their difference right however the first guess came out.
static inline Places places_in_face(V3 met, const Segment& a, const Segment& b, V3 normal)
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
static inline Places places_on_outline(int edge, V3 met, const Segment& a, const Segment& b)
{
    const bool along_b = edge % 2 == 0;
    const double end = edge == 1 || edge == 2 ? 1 : 0;
    if (along_b) return {end, nearest_on(b, met + a.start + end * a.edge)};
    return {nearest_on(a, b.start + end * b.edge - met), end};
}

/// First contact of segments a and b, in the world's axes, each seen from its own body's origin.
template <class Later>
Entry segments_entry(const Segment& a, const Segment& b, const Approach& m, const Reach& r, Later later)
{
    const V3 corner = b.start - a.start, opposite = b.end() - a.end();
    const Polygon difference{{corner, b.end() - a.start, opposite, b.start - a.end()},
                             {b.edge, -a.edge, -b.edge, a.edge},
                             careful_cross(a.edge, b.edge),
                             0.5 * (corner + opposite),
                             0.5 * (norm(a.edge) + norm(b.edge)),
                             true};
    const PolygonEntry met = polygon_entry(difference, m, r, later);
    Entry e = met.entry;
    if (!e.meeting) return e;
    Meeting& at = *e.meeting;
    const Places places = met.edge < 0 ? places_in_face(at.core_b, a, b, difference.normal)
                                       : places_on_outline(met.edge, at.core_b, a, b);
    at.core_a = at.core_a + a.start + places.on_a * a.edge;
    at.core_b = b.start + places.on_b * b.edge;
    return e;
}

} // namespace brink
