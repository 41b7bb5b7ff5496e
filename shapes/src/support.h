// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"
#include "hull_data.h"
#include "round_support.h"
#include "simplex.h"

#include <algorithm>

/// What GJK, separating axes and certificates ask of a core. Radii are left out.
namespace brink {

static inline bool is_polytope(const Core& c) { return c.count > 0; }
/// Whether its features are few enough to be looked at one by one: at most those of a box.
static inline bool is_simple(const Core& c) { return c.kind <= Core::Kind::box; }

/// A box's corner; without branches, as which corner it is can hardly be predicted.
static inline V3 box_corner(const Core& c, int k)
{
    constexpr double side[2] = {-1, 1};
    const V3 h = c.half_extents;
    const V3 on_x = c.centre + side[k & 1] * h.x * c.axes.x;
    const V3 on_y = on_x + side[k >> 1 & 1] * h.y * c.axes.y;
    return on_y + side[k >> 2 & 1] * h.z * c.axes.z;
}

/// Corner k of a polytope, placed, 0 <= k < count. A box's has +x where k & 1, +y where k & 2, +z where
/// k & 4, else -.
static inline V3 corner(const Core& c, int k)
{
    if (c.kind == Core::Kind::hull) return c.axes * c.hull->corner(k) + c.centre;
    return c.kind == Core::Kind::box ? box_corner(c, k) : c.points[k];
}

/// A point of a core, and which corner it is: -1 for shapes that have none.
struct SupportPoint {
    V3 point;
    int corner = -1;
};

SupportPoint farthest_of_hull(const Core&, const V3& d);
/// The corner of the difference B - A that lies farthest against v, of two hulls.
void put_corner_of_hulls(Simplex::Corner&, const Core& a, const Core& b, const V3& v);

/// The normal of the face of a hull that looks most along d, not of unit length; zero where no face is known.
V3 face_towards(const Core& c, V3 d);

static inline SupportPoint farthest_of_others(const Core& c, const V3& d)
{
    if (c.kind == Core::Kind::box) {
        const double x = dot(c.axes.x, d), y = dot(c.axes.y, d), z = dot(c.axes.z, d);
        const int k = static_cast<int>(x > 0) + 2 * static_cast<int>(y > 0) + 4 * static_cast<int>(z > 0);
        return {box_corner(c, k), k};
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

/// A point of the core that lies farthest along d, of any length; any point where d is zero.
[[gnu::always_inline]] static inline SupportPoint farthest(const Core& c, const V3& d)
{
    return c.kind == Core::Kind::hull ? farthest_of_hull(c, d) : farthest_of_others(c, d);
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
    if (c.kind == hull) return {dot(farthest_of_hull(c, -d).point, d), dot(farthest_of_hull(c, d).point, d)};
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

/// The largest d . p over the points p of a core.
[[gnu::always_inline]] static inline double highest(const Core& c, V3 d)
{
    if (c.kind == Core::Kind::hull) return dot(farthest_of_hull(c, d).point, d);
    return interval(c, d).high;
}

/// The distance between the planes at right angles to the unit vector n that support A from below and B from
/// above: a lower bound of the distance between the cores, whatever n.
static inline double gap_along(const Core& a, const Core& b, V3 n) { return -highest(b, -n) - highest(a, n); }

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
