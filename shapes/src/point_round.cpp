// SPDX-License-Identifier: BSD-3-Clause
#include "point_round.h"

#include "nearest.h"

namespace brink {

namespace {

using To = FromPoint::To;

/// In the section, x across the axis and y along it: the way to the nearest point.
struct Way {
    V3 v;
    To to = To::corner;
};

Way to_cylinder(V3 p, V3 h)
{
    const V3 v{std::min(p.x, h.x) - p.x, std::clamp(p.y, -h.z, h.z) - p.y, 0};
    return {v, v.y == 0 ? To::side : v.x == 0 ? To::end : To::corner};
}

FromPoint out_of_cylinder(V3 p, V3 h)
{
    const double side = h.x - p.x, end = h.z - std::fabs(p.y);
    if (side <= end) return {-side, {-1, 0, 0}, To::side};
    return {-end, {0, p.y > 0 ? -1.0 : 1.0, 0}, To::end};
}

/// The cone's slope, outwards; not a unit vector.
V3 slope(V3 h) { return {2 * h.z, h.x, 0}; }

bool in_cone(V3 p, V3 h)
{
    return std::fabs(p.y) <= h.z && p.x <= h.x && dot(slope(h), p - V3{0, h.z, 0}) <= 0;
}

Way to_cone(V3 p, V3 h)
{
    if (in_cone(p, h)) return {};
    const V3 apex = V3{0, h.z, 0} - p, rim = V3{h.x, -h.z, 0} - p, base = V3{0, -h.z, 0} - p;
    const V3 side = to_segment(rim, apex), end = to_segment(base, rim);
    if (norm_squared(end) < norm_squared(side)) return {end, end == rim ? To::corner : To::end};
    return {side, side == rim || side == apex ? To::corner : To::side};
}

FromPoint out_of_cone(V3 p, V3 h)
{
    const V3 out = slope(h);
    const double length = norm(out), base = p.y + h.z;
    if (!(length > 0)) return {0, {0, 1, 0}, To::corner};
    const double side = -dot(out, p - V3{0, h.z, 0}) / length;
    if (base <= side) return {-base, {0, 1, 0}, To::end};
    return {-side, (-1 / length) * out, To::side};
}

} // namespace

FromPoint from_point(V3 point, const Core& c)
{
    const bool cone = c.kind == Core::Kind::cone;
    const double off_axis = std::sqrt(point.x * point.x + point.y * point.y);
    const V3 aside = off_axis > 0 ? V3{point.x / off_axis, point.y / off_axis, 0} : V3{1, 0, 0};
    const V3 p{off_axis, point.z, 0}, h = c.half_extents;
    const auto [v, to] = cone ? to_cone(p, h) : to_cylinder(p, h);
    const double distance = norm(v);
    FromPoint found = cone ? out_of_cone(p, h) : out_of_cylinder(p, h);
    if (distance > 0) found = {distance, (1 / distance) * v, to};
    const V3 n = found.normal;
    return {found.gap, n.x * aside + V3{0, 0, n.y}, found.to};
}

} // namespace brink
