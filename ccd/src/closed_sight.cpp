// SPDX-License-Identifier: BSD-3-Clause
#include "closed_sight.h"

#include "nearest.h"
#include "point_round.h"

namespace brink {

namespace {

using enum Core::Kind;

V3 direction(const Core& segment)
{
    return segment.kind == point ? V3{} : segment.points[1] - segment.points[0];
}

Feature edge_feature(V3 d, double at)
{
    const double length = norm(d);
    if (!(at > 0 && at < 1 && length > 0)) return {};
    return {Feature::Kind::edge, (1 / length) * d};
}

Sight seen(const Facing<Core>& f, const Feature& a, const Feature& b, V3 point_a, V3 v)
{
    Sight s;
    s.upper = norm(v);
    s.point_a = point_a;
    s.v = v;
    if (s.upper > 0) s.normal = (1 / s.upper) * v;
    s.axis = axis_between(a, f.a.rate, b, f.b.rate, v, v);
    return s;
}

/// The part of a box that lies nearest, by which of its sides v leads away from.
Feature box_feature(const Core& box, V3 local)
{
    const bool x = local.x != 0, y = local.y != 0, z = local.z != 0;
    switch (static_cast<int>(x) + static_cast<int>(y) + static_cast<int>(z)) {
    case 1:
        return {Feature::Kind::face, x ? box.axes.x : y ? box.axes.y : box.axes.z};
    case 2:
        return {Feature::Kind::edge, !x ? box.axes.x : !y ? box.axes.y : box.axes.z};
    default:
        return {};
    }
}

struct FromBox {
    V3 v; // from the point to the box
    Feature feature;
};
FromBox from_box(V3 p, const Core& box)
{
    const V3 local = to_box(into(box.axes, p - box.centre), box.half_extents);
    return {box.axes * local, box_feature(box, local)};
}

/// A point or segment, and the fraction of it that comes nearest to a box.
struct OnThin {
    V3 point;
    Feature feature;
};
OnThin nearest_of(const Core& thin, const Core& box)
{
    const V3 p = thin.points[0];
    if (thin.kind == point) return {p, {}};
    const V3 d = direction(thin);
    const double t = nearest_to_box(into(box.axes, p - box.centre), into(box.axes, d), box.half_extents);
    return {p + t * d, edge_feature(d, t)};
}

/// The line of a side that is nearest, or the end of a cylinder or cone.
Feature round_feature(FromPoint::To to, V3 axis, V3 normal)
{
    if (to == FromPoint::To::corner) return {};
    V3 along = axis - dot(axis, normal) * normal;
    along = along - dot(along, normal) * normal; // what rounding left of a flat cone's
    const double length = norm(along);
    if (to == FromPoint::To::end || !(length > 0)) return {Feature::Kind::face, normal};
    return {Feature::Kind::edge, (1 / length) * along};
}

} // namespace

Sight look_at_segments(const Facing<Core>& f)
{
    const Core &a = f.a.part, &b = f.b.part;
    const V3 d = direction(a), e = direction(b), r = b.points[0] - a.points[0];
    const auto [s, t] = nearest_parameters(r, d, e);
    return seen(f, edge_feature(d, s), edge_feature(e, t), a.points[0] + s * d, r + t * e - s * d);
}

Sight look_at_thin_box(const Facing<Core>& f)
{
    const auto [p, of_a] = nearest_of(f.a.part, f.b.part);
    const auto [v, of_b] = from_box(p, f.b.part);
    return seen(f, of_a, of_b, p, v);
}

Sight look_at_point_round(const Facing<Core>& f)
{
    const Core& round = f.b.part;
    const V3 p = f.a.part.points[0];
    const auto [gap, local, to] = from_point(into(round.axes, p - round.centre), round);
    Sight s;
    s.upper = gap;
    s.point_a = p;
    s.normal = round.axes * local;
    s.v = gap * s.normal;
    const Feature of_b = round_feature(to, round.axes.z, s.normal);
    s.axis = axis_between({}, f.a.rate, of_b, f.b.rate, s.normal, s.normal);
    return s;
}

} // namespace brink
