// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tolerance.h"
#include "vector.h"

#include <brink/shape.h>

#include <limits>

/// Whether an input means anything: finite, sizes not negative, normals and quaternions of unit length within
/// the tolerance. Comparisons are written so that NaN fails them.
namespace brink {

static inline bool is_finite(V3 v) { return finite_probe(v) == 0; }
static inline bool is_size(double s) { return s >= 0 && s <= std::numeric_limits<double>::max(); }
static inline bool is_unit_square(double s) { return std::fabs(s - 1) <= tolerance::unit; }

static inline bool valid(const Sphere& s) { return is_size(s.radius); }
static inline bool valid(const Capsule& s)
{
    return finite_probe(load(s.a)) + finite_probe(load(s.b)) == 0 && is_size(s.radius);
}
static inline bool valid(const Box& s)
{
    const V3 h = load(s.half_extents);
    return is_size(h.x) && is_size(h.y) && is_size(h.z);
}
static inline bool valid(const Triangle& s)
{
    return finite_probe(load(s.a)) + finite_probe(load(s.b)) + finite_probe(load(s.c)) == 0;
}
static inline bool valid(const Plane& s)
{
    return is_unit_square(norm_squared(load(s.normal))) && s.offset * 0 == 0;
}
static inline bool valid(const HalfSpace& s)
{
    return is_unit_square(norm_squared(load(s.normal))) && s.offset * 0 == 0;
}
static inline bool valid(const Cylinder& s) { return is_size(s.half_length) && is_size(s.radius); }
static inline bool valid(const Cone& s) { return is_size(s.half_length) && is_size(s.radius); }
static inline bool valid(const Ellipsoid& s)
{
    const V3 r = load(s.radii);
    return is_size(r.x) && is_size(r.y) && is_size(r.z);
}
/// Its points were looked at when it was made.
static inline bool valid(const Hull&) { return true; }
static inline bool valid(const Quat& q)
{
    const double* c = q.coeffs().data();
    return is_unit_square(c[0] * c[0] + c[1] * c[1] + c[2] * c[2] + c[3] * c[3]);
}
static inline bool valid(const Pose& p) { return is_finite(load(p.position)) && valid(p.orientation); }

/// A shape at a pose. The orientation of a sphere cannot matter and is not looked at; a variant that lost its
/// value to an exception is invalid.
static inline bool valid(const Shape& shape, const Pose& pose)
{
    if (const auto* s = std::get_if<Sphere>(&shape)) return valid(*s) && is_finite(load(pose.position));
    if (!valid(pose)) return false;
    if (const auto* s = std::get_if<Capsule>(&shape)) return valid(*s);
    if (const auto* s = std::get_if<Box>(&shape)) return valid(*s);
    if (const auto* s = std::get_if<Triangle>(&shape)) return valid(*s);
    if (const auto* s = std::get_if<Plane>(&shape)) return valid(*s);
    if (const auto* s = std::get_if<HalfSpace>(&shape)) return valid(*s);
    if (const auto* s = std::get_if<Cylinder>(&shape)) return valid(*s);
    if (const auto* s = std::get_if<Cone>(&shape)) return valid(*s);
    if (const auto* s = std::get_if<Ellipsoid>(&shape)) return valid(*s);
    return std::holds_alternative<Hull>(shape);
}

} // namespace brink
