// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"
#include "scaling.h"
#include "tolerance.h"

/// Supporting points of cylinders, cones and ellipsoids, in their own frames about their centres.
namespace brink {

/// The extent of a core along a direction.
struct Interval {
    double low, high;
};

static inline bool keeps_digits(double square)
{
    return square > tolerance::least_square && square < tolerance::largest_square;
}

/// |v|, however large or small.
static inline double careful_norm(V3 v)
{
    const double square = norm_squared(v);
    if (keeps_digits(square) || v == V3{}) return std::sqrt(square);
    const int e = exponent(largest_coordinate(v));
    return std::ldexp(norm(scaled(v, -e)), e);
}

/// A point of the rim of radius h.x about the axis that lies farthest along d; the centre where all do.
static inline V3 rim_support(V3 h, V3 d, double z)
{
    const double across = careful_norm({d.x, d.y, 0});
    return across > 0 ? V3{h.x * (d.x / across), h.x * (d.y / across), z} : V3{0, 0, z};
}

static inline V3 ellipsoid_support(V3 radii, V3 d)
{
    const V3 s{radii.x * d.x, radii.y * d.y, radii.z * d.z};
    const double length = careful_norm(s);
    if (!(length > 0)) return {};
    return {radii.x * (s.x / length), radii.y * (s.y / length), radii.z * (s.z / length)};
}

static inline V3 round_support(const Core& c, V3 d)
{
    const V3 h = c.half_extents;
    if (c.kind == Core::Kind::ellipsoid) return ellipsoid_support(h, d);
    if (c.kind == Core::Kind::cylinder) return rim_support(h, d, d.z > 0 ? h.z : -h.z);
    const bool apex = 2 * h.z * d.z > h.x * careful_norm({d.x, d.y, 0});
    return apex ? V3{0, 0, h.z} : rim_support(h, d, -h.z);
}

static inline Interval round_interval(const Core& c, V3 d)
{
    const V3 h = c.half_extents;
    if (c.kind == Core::Kind::ellipsoid) {
        const double reach = careful_norm({h.x * d.x, h.y * d.y, h.z * d.z});
        return {-reach, reach};
    }
    const double across = h.x * careful_norm({d.x, d.y, 0}), along = h.z * d.z;
    if (c.kind == Core::Kind::cylinder) return {-(across + std::fabs(along)), across + std::fabs(along)};
    return {std::min(along, -along - across), std::max(along, across - along)};
}

} // namespace brink
