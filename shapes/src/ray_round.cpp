// SPDX-License-Identifier: BSD-3-Clause
#include "ray_round.h"

#include <algorithm>

namespace brink {

namespace {

/// The part of a line that lies in some convex set.
struct Chord {
    double enter = infinity, leave = -infinity;
};

Chord common(Chord a, Chord b) { return {std::max(a.enter, b.enter), std::min(a.leave, b.leave)}; }

constexpr Chord whole{-infinity, infinity};

V3 unit(V3 v) { return (1 / norm(v)) * v; }

/// |origin + t direction| <= half, in one coordinate.
Chord slab(double origin, double direction, double half)
{
    if (direction == 0) return std::fabs(origin) <= half ? whole : Chord{};
    const double near = direction > 0 ? -half : half;
    return {(near - origin) / direction, (-near - origin) / direction};
}

/// a t^2 + 2 b t + c <= 0 for a > 0, the discriminant b^2 - a c known by other means.
Chord between_roots(double a, double b, double c, double discriminant)
{
    if (!(discriminant >= 0)) return {};
    const double root = std::sqrt(discriminant), q = b < 0 ? root - b : -(root + b);
    if (q == 0) return {0, 0};
    return b < 0 ? Chord{c / q, q / a} : Chord{q / a, c / q};
}

/// Within `radius` of the z axis.
Chord around_axis(V3 o, V3 d, double radius)
{
    const double a = d.x * d.x + d.y * d.y, b = o.x * d.x + o.y * d.y, square = radius * radius;
    const double c = o.x * o.x + o.y * o.y - square, turn = o.x * d.y - o.y * d.x;
    if (a == 0) return c <= 0 ? whole : Chord{};
    return between_roots(a, b, c, a * square - turn * turn);
}

/// The infinite solid cone below its apex, which is the origin: `height` times the distance from the z axis
/// is at most `radius` times how far below the apex a point is.
Chord below_apex(V3 o, V3 d, double height, double radius)
{
    const double hh = height * height, rr = radius * radius;
    const double a = hh * (d.x * d.x + d.y * d.y) - rr * d.z * d.z;
    const double b = hh * (o.x * d.x + o.y * d.y) - rr * o.z * d.z;
    const double c = hh * (o.x * o.x + o.y * o.y) - rr * o.z * o.z;
    const double x = o.x * d.z - o.z * d.x, y = o.y * d.z - o.z * d.y, turn = o.x * d.y - o.y * d.x;
    const double discriminant = hh * (rr * (x * x + y * y) - hh * turn * turn);
    if (a > 0) {
        const Chord inside = between_roots(a, b, c, discriminant);
        return o.z - b / a * d.z <= 0 ? inside : Chord{};
    }
    // The direction lies in the double cone: the line is in one half of it before, in the other after.
    const bool later = d.z < 0;
    if (a == 0) {
        if (b == 0) return c <= 0 ? whole : Chord{};
        const double t = -c / (b + b);
        if (later != (b < 0)) return {};
        return later ? Chord{t, infinity} : Chord{-infinity, t};
    }
    const Chord outside = between_roots(-a, -b, -c, std::max(0.0, discriminant));
    return later ? Chord{outside.leave, infinity} : Chord{-infinity, outside.enter};
}

/// The first t >= 0 of a chord of which the ray's origin is outside up to rounding.
double first(Chord c)
{
    const double t = std::max(c.enter, 0.0);
    if (t <= c.leave && t < infinity) return t;
    return infinity;
}

SurfaceEntry enter_cylinder(V3 o, V3 d, V3 h)
{
    const Chord ends = slab(o.z, d.z, h.z), side = around_axis(o, d, h.x);
    const double t = first(common(ends, side));
    if (t == infinity) return {};
    const V3 reached = o + t * d;
    const double z = std::clamp(reached.z, -h.z, h.z);
    if (ends.enter >= side.enter)
        return {t, {reached.x, reached.y, d.z > 0 ? -h.z : h.z}, {0, 0, d.z > 0 ? -1.0 : 1.0}};
    const double across = std::sqrt(reached.x * reached.x + reached.y * reached.y);
    if (!(across > 0)) return {t, {0, 0, z}, -unit(d)};
    const V3 n{reached.x / across, reached.y / across, 0};
    return {t, {h.x * n.x, h.x * n.y, z}, n};
}

SurfaceEntry enter_cone(V3 o, V3 d, V3 h)
{
    if (h.z == 0) return enter_cylinder(o, d, h);
    const double height = 2 * h.z;
    const Chord base = slab(o.z, d.z, h.z), side = below_apex({o.x, o.y, o.z - h.z}, d, height, h.x);
    const double t = first(common(base, side));
    if (t == infinity) return {};
    const V3 reached = o + t * d;
    if (base.enter >= side.enter && d.z > 0) return {t, {reached.x, reached.y, -h.z}, {0, 0, -1}};
    const double z = std::clamp(reached.z, -h.z, h.z), across = h.x * ((h.z - z) / height);
    const double off_axis = std::sqrt(reached.x * reached.x + reached.y * reached.y);
    if (!(off_axis > 0)) return {t, {0, 0, z}, -unit(d)};
    const V3 n{reached.x / off_axis, reached.y / off_axis, 0};
    return {t, {across * n.x, across * n.y, z}, unit({height * n.x, height * n.y, h.x})};
}

/// A ball in lengths of its radii.
SurfaceEntry enter_ellipsoid(V3 o, V3 d, V3 radii)
{
    const V3 u{o.x / radii.x, o.y / radii.y, o.z / radii.z}, v{d.x / radii.x, d.y / radii.y, d.z / radii.z};
    const double a = norm_squared(v);
    const double t = first(between_roots(a, dot(u, v), norm_squared(u) - 1, a - norm_squared(cross(u, v))));
    if (t == infinity) return {};
    const V3 reached = u + t * v;
    const V3 on = unit(reached);
    return {t,
            {radii.x * on.x, radii.y * on.y, radii.z * on.z},
            unit({on.x / radii.x, on.y / radii.y, on.z / radii.z})};
}

} // namespace

SurfaceEntry enter_round(V3 origin, V3 direction, const Core& c)
{
    const V3 o = into(c.axes, origin - c.centre), d = into(c.axes, direction), h = c.half_extents;
    const SurfaceEntry e = c.kind == Core::Kind::cylinder ? enter_cylinder(o, d, h)
                           : c.kind == Core::Kind::cone   ? enter_cone(o, d, h)
                                                          : enter_ellipsoid(o, d, h);
    if (e.t == infinity) return e;
    return {e.t, c.centre + c.axes * e.point, c.axes * e.normal};
}

} // namespace brink
