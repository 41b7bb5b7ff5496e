// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "approach.h"
#include "core.h"

namespace brink {

/// B's plane or half-space in Approach's frame.
template <class Shape> Border border_of(const Shape& b, const Approach& m)
{
    return placed(border(b), m.turn_b(), {});
}

/// The convex hull of N moving points, grown by `radius`, against a plane or half-space at rest: whichever
/// point lies lowest stays lowest, so one linear equation decides.
template <int N> Entry border_entry(const V3 (&point)[N], const Border& border, V3 by, double radius)
{
    int lowest = 0, highest = 0;
    double height[N];
    for (int i = 0; i < N; ++i) {
        height[i] = dot(border.normal, point[i]) - border.offset;
        if (height[i] < height[lowest]) lowest = i;
        if (height[i] > height[highest]) highest = i;
    }
    const bool below = !border.solid && height[highest] < -radius;
    const double side = below ? -1 : 1;
    const int nearest = below ? highest : lowest;
    const double above = side * height[nearest] - radius, climb = side * dot(border.normal, by);
    if (above <= 0) return {.t = 0};
    if (!(above <= -climb)) return {}; // later than t = 1
    const double t = above / -climb;
    const V3 at = point[nearest] + t * by;
    return {t, at, at - (dot(border.normal, at) - border.offset) * border.normal, -side * border.normal,
            true};
}

} // namespace brink
