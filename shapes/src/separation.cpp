// SPDX-License-Identifier: BSD-3-Clause
#include "core.h"
#include "nearest.h"
#include "point_round.h"
#include "polytope.h"
#include "scaling.h"
#include "support.h"

#include <algorithm>

namespace brink {

namespace {

bool in_range(double square)
{
    return square > tolerance::least_square && square < tolerance::largest_square;
}

Separation scaled(const Separation& s, int e)
{
    return {std::ldexp(s.lower, e), std::ldexp(s.gap, e), s.normal, scaled(s.point_a, e),
            scaled(s.point_b, e)};
}

Separation core_separation(const Core& a, const Core& b);

/// Where a closed form cannot be certain: because of the scale, which is then mended, or of the place.
Separation the_long_way(const Core& a, const Core& b)
{
    const double scale = std::max(extent(a), extent(b));
    const bool usual = scale >= tolerance::least_scale && scale <= tolerance::largest_scale;
    if (scale == 0 || usual || scale == infinity) return polytope_separation(a, b);
    const int e = exponent(scale);
    return scaled(core_separation(scaled(a, -e), scaled(b, -e)), e);
}

/// The same cores with their radii grown back.
Separation grown(const Separation& cores, double radius_a, double radius_b)
{
    const double radii = radius_a + radius_b;
    return {cores.lower - radii, cores.gap - radii, cores.normal, cores.point_a + radius_a * cores.normal,
            cores.point_b - radius_b * cores.normal};
}

// In what follows A and B are cores, radii left out, and v leads from a point of A to its nearest of B.

Separation point_point(const Core& a, const Core& b)
{
    const V3 v = b.points[0] - a.points[0];
    const double square = norm_squared(v);
    if (!in_range(square)) return the_long_way(a, b);
    const double distance = std::sqrt(square);
    const V3 normal = (1 / distance) * v;
    return {distance, distance, normal, a.points[0], b.points[0]};
}

/// A's point and its nearest of B, v away; the long way where the supporting planes at right angles to v do
/// not confirm the distance. `corners` are B's, relative to A.
template <int count> Separation confirmed(const Core& a, const Core& b, const V3 (&corners)[count], V3 v)
{
    const double square = norm_squared(v), distance = std::sqrt(square);
    const V3 normal = (1 / distance) * v;
    double lower = dot(normal, corners[0]), scale = 0;
    for (const V3 corner : corners) {
        lower = std::min(lower, dot(normal, corner));
        scale = std::max(scale, std::fabs(corner.x) + std::fabs(corner.y) + std::fabs(corner.z));
    }
    if (!in_range(square) || !(distance - lower <= tolerance::tight * scale)) return the_long_way(a, b);
    return {lower, distance, normal, a.points[0], a.points[0] + v};
}

Separation point_segment(const Core& a, const Core& b)
{
    const V3 at = a.points[0], corners[] = {b.points[0] - at, b.points[1] - at};
    return confirmed(a, b, corners, to_segment(corners[0], corners[1]));
}

Separation point_triangle(const Core& a, const Core& b)
{
    const V3 at = a.points[0], corners[] = {b.points[0] - at, b.points[1] - at, b.points[2] - at};
    return confirmed(a, b, corners, to_triangle(corners[0], corners[1], corners[2]));
}

/// A point in a box leaves it through the nearest face.
Separation point_in_box(V3 point, const Core& box, V3 local)
{
    const V3 h = box.half_extents;
    const V3 depth{h.x - std::fabs(local.x), h.y - std::fabs(local.y), h.z - std::fabs(local.z)};
    const bool x = depth.x <= depth.y && depth.x <= depth.z, y = depth.y <= depth.z;
    const double out = x ? local.x : y ? local.y : local.z;
    const V3 axis = x ? box.axes.x : y ? box.axes.y : box.axes.z;
    const double gap = -(x ? depth.x : y ? depth.y : depth.z);
    const V3 normal = out > 0 ? -axis : axis;
    return {gap, gap, normal, point, point + gap * normal};
}

Separation point_box(const Core& a, const Core& b)
{
    const V3 h = b.half_extents;
    const V3 local = into(b.axes, a.points[0] - b.centre);
    const V3 v = to_box(local, h);
    if (v == V3{}) return point_in_box(a.points[0], b, local);
    const double square = norm_squared(v);
    if (!in_range(square)) return the_long_way(a, b);
    const double distance = std::sqrt(square);
    const V3 normal = (1 / distance) * v; // in the box's frame
    const double reach = h.x * std::fabs(normal.x) + h.y * std::fabs(normal.y) + h.z * std::fabs(normal.z);
    return {-dot(normal, local) - reach, distance, b.axes * normal, a.points[0], a.points[0] + b.axes * v};
}

Separation point_round(const Core& a, const Core& b)
{
    const V3 local = into(b.axes, a.points[0] - b.centre);
    const double square = norm_squared(local) + norm_squared(b.half_extents);
    if (!in_range(square) && square != 0) return the_long_way(a, b);
    const FromPoint found = from_point(local, b);
    if (found.gap != 0 && !in_range(found.gap * found.gap)) return the_long_way(a, b);
    const double lower = round_interval(b, found.normal).low - dot(found.normal, local);
    const V3 normal = b.axes * found.normal;
    return {std::min(lower, found.gap), found.gap, normal, a.points[0], a.points[0] + found.gap * normal};
}

Separation segment_segment(const Core& a, const Core& b)
{
    const V3 d = a.points[1] - a.points[0], e = b.points[1] - b.points[0], r = b.points[0] - a.points[0];
    const auto [s, t] = nearest_parameters(r, d, e);
    const V3 v = r + t * e - s * d;
    const double square = norm_squared(v), distance = std::sqrt(square);
    const V3 normal = (1 / distance) * v;
    const double near = std::min(0.0, dot(normal, e)), far = std::max(0.0, dot(normal, d));
    const double lower = dot(normal, r) + near - far;
    const double scale = std::sqrt(norm_squared(r) + norm_squared(d) + norm_squared(e));
    if (!in_range(square) || !(distance - lower <= tolerance::tight * scale)) return the_long_way(a, b);
    const V3 point_a = a.points[0] + s * d;
    return {lower, distance, normal, point_a, point_a + v};
}

Separation core_separation(const Core& a, const Core& b)
{
    using enum Core::Kind;
    if (a.kind == point) {
        switch (b.kind) {
        case point:
            return point_point(a, b);
        case segment:
            return point_segment(a, b);
        case triangle:
            return point_triangle(a, b);
        case box:
            return point_box(a, b);
        case cylinder:
        case cone:
            return point_round(a, b);
        default:
            break;
        }
    } else if (b.kind == point)
        return flipped(core_separation(b, a));
    if (a.kind == segment && b.kind == segment) return segment_segment(a, b);
    return the_long_way(a, b);
}

struct Extremes {
    V3 lowest, highest;
};

/// The points of a core that lie lowest and highest along n.
Extremes extremes(const Core& c, V3 n)
{
    if (!is_simple(c)) return {farthest(c, -n).point, farthest(c, n).point};
    Extremes e{corner(c, 0), corner(c, 0)};
    for (int k = 1; k < c.count; ++k) {
        const V3 point = corner(c, k);
        if (dot(n, point) < dot(n, e.lowest)) e.lowest = point;
        if (dot(n, point) > dot(n, e.highest)) e.highest = point;
    }
    return e;
}

} // namespace

Separation separation(const Core& a, const Core& b)
{
    return grown(core_separation(a, b), a.radius, b.radius);
}

Separation separation(const Core& a, const Border& b)
{
    const auto [lowest, highest] = extremes(a, b.normal);
    const double low = dot(b.normal, lowest), high = dot(b.normal, highest);
    const double above = (low - b.offset) - a.radius, below = (b.offset - high) - a.radius;
    const bool from_above = b.solid || above >= below;
    const double gap = from_above ? above : below;
    const V3 normal = from_above ? -b.normal : b.normal;
    const V3 point = (from_above ? lowest : highest) + a.radius * normal;
    return {gap, gap, normal, point, point + gap * normal};
}

} // namespace brink
