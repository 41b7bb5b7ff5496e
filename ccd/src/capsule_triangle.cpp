// SPDX-License-Identifier: BSD-3-Clause
#include "glance.h"
#include "pairs.h"
#include "segments.h"
#include "sharp.h"

#include <algorithm>

namespace brink {

namespace {

/// The difference of a triangle and a segment, a prism: a moving point first meets one of the faces that look
/// against its path, or their edges.
class Prism {
public:
    Prism(const Capsule& a, const Triangle& b, const Approach& m)
        : a_(a), b_(b), whole_(whole_step(m)), target_gap_(m.target_gap)
    {
        const Rotation turn_a = m.turn_a(), turn_b = m.turn_b();
        end_[0] = turn_a * load(a.a);
        end_[1] = turn_a * load(a.b);
        corner_[0] = turn_b * load(b.a);
        corner_[1] = turn_b * load(b.b);
        corner_[2] = turn_b * load(b.c);
        const double squared_a = std::max(norm_squared(end_[0]), norm_squared(end_[1]));
        const double squared_b =
            std::max({norm_squared(corner_[0]), norm_squared(corner_[1]), norm_squared(corner_[2])});
        extents_ = std::sqrt(squared_a) + std::sqrt(squared_b);
        reach_ = reach(m, a.radius + m.target_gap, extents_);
        normal_ = careful_cross(corner_[1] - corner_[0], corner_[2] - corner_[0]);
    }

    Entry entry() const;

private:
    V3 edge() const { return end_[1] - end_[0]; }
    double later(V3 axis, double t) const
    {
        const Pair radius = two_sum(a_.radius, target_gap_);
        return sharp::later(a_, b_, whole_, axis, radius, reach_.lengths + extents_, t);
    }
    /// A face's plane.
    struct Side {
        V3 outward;    // its normal
        double height; // of the path's start over it, in lengths
        bool sure;     // whether rounding cannot have taken inside for outside

        Side(V3 normal, double inward, double sizes, double above)
            : outward(inward > 0 ? -normal : normal),
              height((inward > 0 ? -above : above) / norm(normal)),
              sure(std::fabs(inward) > tolerance::edge_on * sizes)
        {
        }
    };
    Side end_side(int end) const;
    Side edge_side(int corner) const;
    /// Whether it may be met from outside.
    bool looks_back(const Side& s) const
    {
        return !s.sure ||
               !(dot(s.outward, whole_.by) > tolerance::edge_on * norm(s.outward) * norm(whole_.by));
    }
    bool passes_by(double radius) const;
    Entry triangle_entry(int end) const;
    Entry side_entry(int corner) const;

    const Capsule& a_;
    const Triangle& b_;
    Approach whole_;
    double target_gap_, extents_ = 0;
    V3 end_[2], corner_[3], normal_;
    Reach reach_{};
};

/// The triangle seen from one end of the segment.
Entry Prism::triangle_entry(int end) const
{
    const V3 shift = end_[end], p = corner_[0] - shift, q = corner_[1] - shift, s = corner_[2] - shift;
    const V3 centre = (1.0 / 3) * (p + q + s);
    const double squared =
        std::max({norm_squared(p - centre), norm_squared(q - centre), norm_squared(s - centre)});
    const Polygon face{{p, q, s, p}, {q - p, s - q, p - s, {}}, normal_, centre, std::sqrt(squared), false};
    Entry e = polygon_entry(face, whole_, reach_, [this](V3 axis, double t) { return later(axis, t); }).entry;
    if (!e.meeting) return e;
    e.meeting->core_a = e.meeting->core_a + shift;
    e.meeting->core_b = e.meeting->core_b + shift;
    return e;
}

/// The side that one of the triangle's edges makes with the segment.
Entry Prism::side_entry(int corner) const
{
    const V3 start = corner_[corner], along = corner_[(corner + 1) % 3] - start;
    return segments_entry({end_[0], edge()}, {start, along}, whole_, reach_,
                          [this](V3 axis, double t) { return later(axis, t); });
}

/// Whether the path's line passes by a ball about the prism, that of the triangle grown by `radius`.
bool Prism::passes_by(double radius) const
{
    const V3 middle = (1.0 / 3) * (corner_[0] + corner_[1] + corner_[2]);
    const double squared = std::max({norm_squared(corner_[0] - middle), norm_squared(corner_[1] - middle),
                                     norm_squared(corner_[2] - middle)});
    return passes(whole_.from, whole_.by, middle - (end_[0] + 0.5 * edge()),
                  (std::sqrt(squared) + radius) * (1 + tolerance::holding_slack));
}

/// The triangle that an end makes: from the one at end 0 the prism reaches against the segment. `inward` is
/// the height of the other end's over it, times as much as the normal's length.
Prism::Side Prism::end_side(int end) const
{
    const double rise = dot(normal_, edge()), inward = end == 0 ? -rise : rise;
    const double area = norm(corner_[1] - corner_[0]) * norm(corner_[2] - corner_[0]);
    return {normal_, inward, area * norm(edge()), dot(normal_, whole_.from - (corner_[0] - end_[end]))};
}

Prism::Side Prism::edge_side(int corner) const
{
    const V3 start = corner_[corner], along = corner_[(corner + 1) % 3] - start;
    const V3 across = corner_[(corner + 2) % 3] - start, normal = careful_cross(edge(), along);
    return {normal, dot(normal, across), norm(edge()) * norm(along) * norm(across),
            dot(normal, whole_.from - (start - end_[0]))};
}

Entry Prism::entry() const
{
    const double wide = reach_.radius + reach_.margin;
    if (passes_by(wide + 0.5 * norm(edge()))) return {.found = Found::apart};
    const Side sides[] = {end_side(0), end_side(1), edge_side(0), edge_side(1), edge_side(2)};
    double highest = -infinity;
    bool flat = false;
    for (const Side& side : sides) {
        flat |= !side.sure;
        if (side.sure && side.height > highest) highest = side.height;
    }
    if (!flat && highest <= reach_.margin) return {}; // it starts inside
    Entry first{.found = Found::apart};
    for (int k = 0; k < 5; ++k) {
        if (highest > wide && !looks_back(sides[k])) continue;
        const Entry e = k < 2 ? triangle_entry(k) : side_entry(k - 2);
        if (e.found != Found::apart && (first.found == Found::apart || e.t < first.t)) first = e;
    }
    return first;
}

} // namespace

Entry capsule_triangle(const Capsule& a, const Triangle& b, const Approach& m)
{
    return cut(Prism(a, b, m).entry(), m.t_max);
}

} // namespace brink
