// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_features.h"
#include "nearest.h"
#include "point_round.h"

/// Looks that a closed form answers. What they find is told at once, and the features only where they are
/// asked for: guesses of contact need no more than the points.
namespace brink {

/// Where two bodies come nearest.
struct Glance {
    double upper = 0;          // the distance, radii left out; of a solid it may be negative
    V3 normal;                 // unit, from A towards B; zero where the points are the same
    V3 point_a, v;             // A's, and from there to B's
    double on_a = 0, on_b = 0; // the fractions of segments
    V3 local;                  // v in the axes of a box
    FromPoint::To to{};        // the part of a cylinder or cone
};

static inline V3 direction(const Core& segment)
{
    return segment.kind == Core::Kind::point ? V3{} : segment.points[1] - segment.points[0];
}

static inline Feature edge_feature(V3 d, double at)
{
    const double length = norm(d);
    if (!(at > 0 && at < 1 && length > 0)) return {};
    return {Feature::Kind::edge, (1 / length) * d};
}

/// The part of a box that lies nearest, by which of its sides v leads away from.
static inline Feature box_feature(const Core& box, V3 local)
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

/// The line of a side that is nearest, or the end of a cylinder or cone.
static inline Feature round_feature(FromPoint::To to, V3 axis, V3 normal)
{
    if (to == FromPoint::To::corner) return {};
    V3 along = axis - dot(axis, normal) * normal;
    along = along - dot(along, normal) * normal; // what rounding left of a flat cone's
    const double length = norm(along);
    if (to == FromPoint::To::end || !(length > 0)) return {Feature::Kind::face, normal};
    return {Feature::Kind::edge, (1 / length) * along};
}

/// Points or segments.
struct AtSegments {
    static Glance glance(const Core& a, const Core& b)
    {
        const V3 d = direction(a), e = direction(b), r = b.points[0] - a.points[0];
        Glance g;
        const auto [s, t] = nearest_parameters(r, d, e);
        g.on_a = s;
        g.on_b = t;
        g.point_a = a.points[0] + s * d;
        g.v = r + t * e - s * d;
        g.upper = norm(g.v);
        if (g.upper > 0) g.normal = (1 / g.upper) * g.v;
        return g;
    }
    static Features features(const Core& a, const Core& b, const Glance& g)
    {
        return {edge_feature(direction(a), g.on_a), edge_feature(direction(b), g.on_b)};
    }
};

/// A, a point or segment, and a box.
struct AtThinBox {
    static Glance glance(const Core& thin, const Core& box)
    {
        Glance g;
        const V3 p = into(box.axes, thin.points[0] - box.centre), d = into(box.axes, direction(thin));
        if (thin.kind == Core::Kind::segment) g.on_a = nearest_to_box(p, d, box.half_extents);
        g.point_a = thin.points[0] + g.on_a * direction(thin);
        g.local = to_box(into(box.axes, g.point_a - box.centre), box.half_extents);
        g.v = box.axes * g.local;
        g.upper = norm(g.v);
        if (g.upper > 0) g.normal = (1 / g.upper) * g.v;
        return g;
    }
    static Features features(const Core& thin, const Core& box, const Glance& g)
    {
        return {edge_feature(direction(thin), g.on_a), box_feature(box, g.local)};
    }
};

/// A, a point, and a cylinder or cone.
struct AtPointRound {
    static Glance glance(const Core& point, const Core& round)
    {
        Glance g;
        g.point_a = point.points[0];
        const auto [gap, local, to] = from_point(into(round.axes, g.point_a - round.centre), round);
        g.upper = gap;
        g.normal = round.axes * local;
        g.v = gap * g.normal;
        g.to = to;
        return g;
    }
    static Features features(const Core&, const Core& round, const Glance& g)
    {
        return {{}, round_feature(g.to, round.axes.z, g.normal)};
    }
};

} // namespace brink
