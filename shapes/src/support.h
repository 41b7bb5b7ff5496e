// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"
#include "hull_data.h"
#include "round_support.h"

#include <algorithm>

/// What GJK, separating axes and certificates ask of a core. Radii are left out.
namespace brink {

static inline bool is_polytope(const Core& c) { return c.count > 0; }
/// Whether its features are few enough to be looked at one by one: at most those of a box.
static inline bool is_simple(const Core& c) { return c.kind <= Core::Kind::box; }

/// Corner k of a polytope, placed, 0 <= k < count. A box's has +x where k & 1, +y where k & 2, +z where
/// k & 4, else -.
static inline V3 corner(const Core& c, int k)
{
    const auto bit = static_cast<unsigned>(k);
    if (c.kind == Core::Kind::hull) return c.axes * c.hull->corner(k) + c.centre;
    if (c.kind != Core::Kind::box) return c.points[k];
    const V3 h = c.half_extents;
    const V3 on_x = c.centre + ((bit & 1U) != 0 ? h.x : -h.x) * c.axes.x;
    const V3 on_y = on_x + ((bit & 2U) != 0 ? h.y : -h.y) * c.axes.y;
    return on_y + ((bit & 4U) != 0 ? h.z : -h.z) * c.axes.z;
}

/// A point of a core, and which corner it is: -1 for shapes that have none.
struct SupportPoint {
    V3 point;
    int corner = -1;
};

/// A point of the core that lies farthest along d, of any length; any point where d is zero.
static inline SupportPoint farthest(const Core& c, V3 d)
{
    using enum Core::Kind;
    if (c.kind == box) {
        const double x = dot(c.axes.x, d), y = dot(c.axes.y, d), z = dot(c.axes.z, d);
        const V3 h = c.half_extents;
        const int k = (x > 0 ? 1 : 0) + (y > 0 ? 2 : 0) + (z > 0 ? 4 : 0);
        const V3 on_x = c.centre + (x > 0 ? h.x : -h.x) * c.axes.x;
        const V3 on_y = on_x + (y > 0 ? h.y : -h.y) * c.axes.y;
        return {on_y + (z > 0 ? h.z : -h.z) * c.axes.z, k};
    }
    if (c.kind == hull) {
        const int k = farthest(*c.hull, into(c.axes, d));
        return {corner(c, k), k};
    }
    if (!is_polytope(c)) return {c.centre + c.axes * round_support(c, into(c.axes, d)), -1};
    int best = 0;
    double highest = dot(c.points[0], d);
    for (int k = 1; k < c.count; ++k) {
        const double height = dot(c.points[k], d);
        if (height > highest) highest = height, best = k;
    }
    return {c.points[best], best};
}

/// The extent of a core along a direction.
static inline Interval interval(const Core& c, V3 d)
{
    using enum Core::Kind;
    if (c.kind == box) {
        const V3 h = c.half_extents;
        const double middle = dot(c.centre, d);
        const double reach = h.x * std::fabs(dot(c.axes.x, d)) + h.y * std::fabs(dot(c.axes.y, d)) +
                             h.z * std::fabs(dot(c.axes.z, d));
        return {middle - reach, middle + reach};
    }
    if (c.kind == hull) return {dot(farthest(c, -d).point, d), dot(farthest(c, d).point, d)};
    if (!is_polytope(c)) {
        const double middle = dot(c.centre, d);
        const Interval i = round_interval(c, into(c.axes, d));
        return {middle + i.low, middle + i.high};
    }
    Interval i{dot(c.points[0], d), dot(c.points[0], d)};
    for (int k = 1; k < c.count; ++k) {
        const double height = dot(c.points[k], d);
        i = {std::min(i.low, height), std::max(i.high, height)};
    }
    return i;
}

/// The distance between the planes at right angles to the unit vector n that support A from below and B from
/// above: a lower bound of the distance between the cores, whatever n.
static inline double gap_along(const Core& a, const Core& b, V3 n)
{
    return interval(b, n).low - interval(a, n).high;
}

/// A point in the midst of a core.
static inline V3 middle(const Core& c)
{
    if (c.kind == Core::Kind::hull) return c.axes * c.hull->middle + c.centre;
    return c.kind <= Core::Kind::triangle ? c.points[0] : c.centre;
}

/// The largest coordinate of a core, without its sign. Where corners are many or none it may be somewhat
/// less: the largest of what its points are computed from.
double extent(const Core&);

/// An upper bound of the distance of a core's points from the origin, up to rounding; the least one where
/// corners are few.
double reach(const Core&);

} // namespace brink
