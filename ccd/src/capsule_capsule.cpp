// SPDX-License-Identifier: BSD-3-Clause
#include "pairs.h"
#include "rounded_polygon.h"

namespace brink {

namespace {

struct Segment {
    V3 start, edge;
};

/// Where on the segment, 0 to 1, `point` comes nearest.
double nearest_on(const Segment& s, V3 point)
{
    const double length_squared = norm_squared(s.edge);
    if (length_squared == 0) return 0;
    const double along = dot(point - s.start, s.edge) / length_squared;
    return along < 0 ? 0 : along > 1 ? 1 : along;
}

/// Turns a point of the parallelogram B - A back into a point of each segment. Parallel segments leave a
/// choice; the second and third projections keep their difference right however the first one came out.
Entry split(const Entry& e, const Segment& a, const Segment& b)
{
    const V3 across = cross(b.edge, a.edge), q = e.core_b - (b.start - a.start);
    const double area_squared = norm_squared(across);
    const double guess = area_squared > 0 ? dot(cross(q, a.edge), across) / area_squared : 0;
    const double first_v = guess < 0 ? 0 : guess > 1 ? 1 : guess;
    const double u = nearest_on(a, b.start + first_v * b.edge - e.core_b);
    const double v = nearest_on(b, e.core_b + a.start + u * a.edge);
    return {e.t, e.core_a + a.start + u * a.edge, b.start + v * b.edge, e.facing, e.flat};
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
    const Entry e = polygon_entry(difference, m.from, m.by, a.radius + b.radius + m.target_gap);
    if (e.t == 0 || e.t == infinity) return e;
    return split(e, {a0, edge_a}, {b0, edge_b});
}

} // namespace brink
