// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"

#include <algorithm>

/// What GJK and separating axes ask of a core. Radii are left out.
namespace brink {

/// The corner farthest along d.
static inline int farthest(const Core& c, V3 d)
{
    if (c.kind == Core::Kind::box) {
        const int x = dot(c.axes.x, d) > 0 ? 1 : 0, y = dot(c.axes.y, d) > 0 ? 2 : 0;
        return x + y + (dot(c.axes.z, d) > 0 ? 4 : 0);
    }
    int best = 0;
    double highest = dot(c.points[0], d);
    for (int k = 1; k < c.count; ++k) {
        const double height = dot(c.points[k], d);
        if (height > highest) highest = height, best = k;
    }
    return best;
}

/// The extent of a core along a direction.
struct Interval {
    double low, high;
};

static inline Interval interval(const Core& c, V3 d)
{
    if (c.kind == Core::Kind::box) {
        const V3 h = c.half_extents;
        const double middle = dot(c.centre, d);
        const double reach = h.x * std::fabs(dot(c.axes.x, d)) + h.y * std::fabs(dot(c.axes.y, d)) +
                             h.z * std::fabs(dot(c.axes.z, d));
        return {middle - reach, middle + reach};
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

/// The largest coordinate of a core, without its sign.
static inline double extent(const Core& c)
{
    double largest = 0;
    for (int k = 0; k < c.count; ++k) {
        const V3 p = c.points[k];
        largest = std::max(largest, std::max(std::fabs(p.x), std::max(std::fabs(p.y), std::fabs(p.z))));
    }
    return largest;
}

} // namespace brink
