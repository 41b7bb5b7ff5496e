// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "crossing.h"

#include <brink/shape.h>

#include <type_traits>

namespace brink {

/// A plane's or half-space's normal in world axes, every component within a few u of the largest (a rotation
/// matrix of doubles is off by ten times that, which a long lever arm shows), times the squared norm of the
/// quaternion; and the offset times that.
struct TurnedBorder {
    V3 normal;
    double offset;
    bool solid;
};

namespace border {
static inline Pair sum(Pair a, Pair b)
{
    const Pair s = two_sum(a.hi, b.hi);
    return {s.hi, s.lo + (a.lo + b.lo)};
}
static inline Pair minus(Pair a) { return {-a.hi, -a.lo}; }
static inline Pair twice(Pair a) { return {2 * a.hi, 2 * a.lo}; }
/// (a, b, c) . n
static inline double dot(Pair a, Pair b, Pair c, V3 n)
{
    const Pair x = two_product(a.hi, n.x), y = two_product(b.hi, n.y), z = two_product(c.hi, n.z);
    const Pair s = sum(sum(x, y), z);
    return s.hi + (s.lo + (a.lo * n.x + b.lo * n.y + c.lo * n.z));
}
} // namespace border

template <class Shape> TurnedBorder border_of(const Shape& b, const Approach& m)
{
    constexpr bool solid = std::is_same_v<Shape, HalfSpace>;
    const double* q = m.motion_b.start.orientation.coeffs().data();
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const V3 n = load(b.normal);
    if (x == 0 && y == 0 && z == 0 && w * w == 1) return {n, b.offset, solid};
    using namespace border;
    const Pair xx = two_product(x, x), yy = two_product(y, y), zz = two_product(z, z), ww = two_product(w, w);
    const Pair xy = two_product(x, y), xz = two_product(x, z), yz = two_product(y, z);
    const Pair wx = two_product(w, x), wy = two_product(w, y), wz = two_product(w, z);
    const Pair x_y = sum(xx, minus(yy)), w_z = sum(ww, minus(zz));
    const V3 normal{
        dot(sum(w_z, x_y), twice(sum(xy, minus(wz))), twice(sum(xz, wy)), n),
        dot(twice(sum(xy, wz)), sum(w_z, minus(x_y)), twice(sum(yz, minus(wx))), n),
        dot(twice(sum(xz, minus(wy))), twice(sum(yz, wx)), sum(sum(ww, zz), minus(sum(xx, yy))), n)};
    const Pair norm_squared = sum(sum(xx, yy), sum(zz, ww));
    return {normal, b.offset * norm_squared.hi, solid};
}

/// The convex hull of N moving points, grown by `radius`, against a plane or half-space at rest: whichever
/// point lies lowest stays lowest, so one linear equation decides. `extent`: how far a rotation has moved the
/// points from A's origin.
template <int N>
Entry border_entry(const V3 (&point)[N], const TurnedBorder& border, const Approach& m, double radius,
                   double extent)
{
    int lowest = 0, highest = 0;
    double height[N];
    for (int i = 0; i < N; ++i) {
        height[i] = dot(border.normal, point[i]) - border.offset;
        if (height[i] < height[lowest]) lowest = i;
        if (height[i] > height[highest]) highest = i;
    }
    const double length = norm(border.normal);
    const Reach r = reach(m, radius + std::fabs(border.offset), extent);
    const double near = radius * length, slack = r.slack * length;
    const bool below = !border.solid && height[highest] < -near;
    const double side = below ? -1 : 1;
    const int nearest = below ? highest : lowest;
    const double above = side * height[nearest] - near, rate = -side * dot(border.normal, m.by);
    if (above < -slack && (border.solid || (height[lowest] < near - slack && height[highest] > slack - near)))
        return {.found = Found::start};
    if (above > slack && above - rate * m.t_max > 2 * slack) return {.found = Found::apart};
    const Crossing c = crossing(above, rate, slack);
    if (!c.closing) return {};
    if (c.t > m.t_max) return {.found = Found::apart};
    const V3 at = point[nearest] + c.t * m.by, normal = (1 / length) * border.normal;
    const double over = (side * height[nearest] - c.t * rate) / length;
    const bool late = c.t_upper > m.t_max;
    return {late ? Found::doubt : Found::hit,
            c.t,
            late ? infinity : c.t_upper,
            late,
            at,
            at - (side * over) * normal,
            -side * normal,
            true};
}

} // namespace brink
