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
    /// Whether a face may be met from outside: one with that normal, which points outwards if `inward` does
    /// not; both when `inward` is no more than a part of `sizes` that rounding could be.
    bool faces(V3 normal, double inward, double sizes) const
    {
        if (std::fabs(inward) <= tolerance::edge_on * sizes) return true;
        const double leaving = inward > 0 ? -dot(normal, whole_.by) : dot(normal, whole_.by);
        return !(leaving > tolerance::edge_on * norm(normal) * norm(whole_.by));
    }
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

Entry Prism::entry() const
{
    Entry first{.found = Found::apart};
    bool inside = true;
    const double wide = reach_.radius + reach_.margin, length = norm(edge());
    const auto take = [&](const Entry& e) {
        if (e.found != Found::apart && (first.found == Found::apart || e.t < first.t)) first = e;
    };
    const auto over = [&](V3 normal, double inward, double level) {
        const double height = dot(normal, whole_.from) - level;
        inside &= (inward > 0 ? -height : height) <= wide * norm(normal);
    };
    // From the triangle that end 0 makes, the prism reaches against the segment.
    const double rise = dot(normal_, edge());
    const double area = norm(corner_[1] - corner_[0]) * norm(corner_[2] - corner_[0]);
    for (int end = 0; end < 2; ++end) {
        const double inward = end == 0 ? -rise : rise;
        over(normal_, inward, dot(normal_, corner_[0] - end_[end]));
        if (faces(normal_, inward, area * length)) take(triangle_entry(end));
    }
    for (int k = 0; k < 3; ++k) {
        const V3 along = corner_[(k + 1) % 3] - corner_[k], across = corner_[(k + 2) % 3] - corner_[k];
        const V3 normal = careful_cross(edge(), along);
        const double inward = dot(normal, across);
        over(normal, inward, dot(normal, corner_[k] - end_[0]));
        if (faces(normal, inward, length * norm(along) * norm(across))) take(side_entry(k));
    }
    return inside ? Entry{} : first;
}

} // namespace

Entry capsule_triangle(const Capsule& a, const Triangle& b, const Approach& m)
{
    return cut(Prism(a, b, m).entry(), m.t_max);
}

} // namespace brink
