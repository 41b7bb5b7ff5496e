// SPDX-License-Identifier: BSD-3-Clause
#include "reference_gap.h"

#include "reference_features.h"

#include <algorithm>

namespace brink::support {
namespace {

using Kind = Placed::Kind;

Real3 at(const RealPose& pose, const Vec3& local) { return pose.position + pose.orientation * real3(local); }

Placed place(const Sphere& s, const RealPose& pose)
{
    Placed out;
    out.kind = Kind::point;
    out.radius = s.radius;
    out.corners[0] = pose.position;
    out.corner_count = 1;
    return out;
}

Placed place(const Capsule& s, const RealPose& pose)
{
    Placed out;
    out.kind = Kind::segment;
    out.radius = s.radius;
    out.corners[0] = at(pose, s.a);
    out.corners[1] = at(pose, s.b);
    out.corner_count = 2;
    return out;
}

Placed place(const Triangle& s, const RealPose& pose)
{
    Placed out;
    out.kind = Kind::triangle;
    out.corners[0] = at(pose, s.a);
    out.corners[1] = at(pose, s.b);
    out.corners[2] = at(pose, s.c);
    out.corner_count = 3;
    return out;
}

Placed place(const Box& s, const RealPose& pose)
{
    Placed out;
    out.kind = Kind::box;
    out.centre = pose.position;
    out.axes = pose.orientation;
    out.half = real3(s.half_extents);
    out.corner_count = 8;
    for (std::size_t i = 0; i < 8; ++i) {
        const Real3 corner{(i & 1U) != 0 ? out.half.x : -out.half.x, (i & 2U) != 0 ? out.half.y : -out.half.y,
                           (i & 4U) != 0 ? out.half.z : -out.half.z};
        out.corners[i] = out.centre + out.axes * corner;
    }
    return out;
}

Placed unbounded(Kind kind, const Vec3& normal, double offset, const RealPose& pose)
{
    Placed out;
    out.kind = kind;
    const Real3 n = real3(normal);
    const Real length = norm(n);
    out.normal = (1 / length) * (pose.orientation * n);
    out.offset = offset / length + dot(out.normal, pose.position);
    return out;
}

Placed place(const Plane& s, const RealPose& pose)
{
    return unbounded(Kind::plane, s.normal, s.offset, pose);
}

Placed place(const HalfSpace& s, const RealPose& pose)
{
    return unbounded(Kind::half_space, s.normal, s.offset, pose);
}

Vector<Real> vector(const Real3& v) { return {v.x, v.y, v.z}; }
Real3 real3(const Vector<Real>& v) { return {v.x, v.y, v.z}; }
using support::real3;

template <class Curved> Placed place(const Curved& s, const RealPose& pose)
{
    Placed out;
    out.kind = Kind::solid;
    out.solid = std::make_shared<const Solid<Real>>(solid<Real>(s));
    const Real33& m = pose.orientation;
    out.placement = placed(*out.solid, vector(pose.position), {vector(m.x), vector(m.y), vector(m.z)});
    return out;
}

/// The same core for bracket(), in the frame of the corners.
Placed as_solid(const Placed& s)
{
    if (s.kind == Kind::solid) return s;
    Placed out = s;
    Solid<Real> core;
    core.core = Core::cloud;
    for (std::size_t i = 0; i < s.corner_count; ++i)
        core.corners.push_back(vector(s.corners[i]));
    out.solid = std::make_shared<const Solid<Real>>(core);
    out.placement = placed(*out.solid, {}, Matrix<Real>{});
    return out;
}

Gap gap_of_solids(const Placed& a, const Placed& b)
{
    const Placed solid_a = as_solid(a);
    const Placed solid_b = as_solid(b);
    const Bracket<Real> found = bracket(solid_a.placement, solid_b.placement, Real(0));
    const Real3 n = real3(found.normal);
    const Real gap = found.upper - a.radius - b.radius;
    return {gap, n, real3(found.point_a) + a.radius * n, real3(found.point_b) - b.radius * n,
            found.points_known};
}

/// A bounded shape against a plane or a half-space.
Gap gap_above(const Placed& body, const Placed& ground)
{
    const auto height = [&](const Real3& p) { return dot(ground.normal, p) - ground.offset; };
    const Real3 lowest = farthest(body, -ground.normal);
    const Real3 highest = farthest(body, ground.normal);
    const Real above = height(lowest) - body.radius;
    const Real below = -height(highest) - body.radius;
    if (ground.kind == Kind::half_space || above >= below) {
        const Real3 on_body = lowest - body.radius * ground.normal;
        return {above, -ground.normal, on_body, on_body - above * ground.normal, true};
    }
    const Real3 on_body = highest + body.radius * ground.normal;
    return {below, ground.normal, on_body, on_body + below * ground.normal, true};
}

Gap flipped(const Gap& g) { return {g.gap, -g.normal, g.point_b, g.point_a, g.points_known}; }

} // namespace

Real33 rotation_matrix(const Quat& q)
{
    const Real w = q.w();
    const Real x = q.x();
    const Real y = q.y();
    const Real z = q.z();
    const Real s = 2 / (w * w + x * x + y * y + z * z);
    return {{1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)},
            {s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x)},
            {s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y)}};
}

Placed place(const Shape& shape, const RealPose& pose)
{
    return std::visit([&](const auto& s) { return place(s, pose); }, shape);
}

Real3 farthest(const Placed& s, const Real3& n)
{
    if (s.kind == Kind::solid) return real3(s.placement.support(vector(n)));
    std::size_t best = 0;
    for (std::size_t i = 1; i < s.corner_count; ++i)
        if (dot(n, s.corners[i]) > dot(n, s.corners[best])) best = i;
    return s.corners[best];
}

Gap gap(const Placed& a, const Placed& b)
{
    if (b.unbounded()) return gap_above(a, b);
    if (a.unbounded()) return flipped(gap_above(b, a));
    if (a.kind == Kind::solid || b.kind == Kind::solid) return gap_of_solids(a, b);
    const Real radii = a.radius + b.radius;
    if (cores_meet(a, b)) {
        // Thin triangles may seem pierced by rounding; an axis that separates is proof that they are not.
        const Separation depth = separating_axes(a, b);
        if (depth.along <= 0) return {depth.along - radii, depth.normal, {}, {}, false};
    }
    const Nearest near = nearest_features(a, b);
    const Real3 n = direction(near.on_b - near.on_a);
    return {std::sqrt(near.squared) - radii, n, near.on_a + a.radius * n, near.on_b - b.radius * n, true};
}

Real gap_to_point(const Placed& shape, const Real3& point)
{
    Placed dot_shape;
    dot_shape.corners[0] = point;
    dot_shape.corner_count = 1;
    return gap(shape, dot_shape).gap;
}

} // namespace brink::support
