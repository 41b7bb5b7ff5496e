// SPDX-License-Identifier: BSD-3-Clause
#include "exact_mover.h"

namespace brink::support {

namespace {

/// M(q) / |q|^2.
Real33 matrix(const Quat& q)
{
    const Real w = q.w(), x = q.x(), y = q.y(), z = q.z(), s = 2 / (w * w + x * x + y * y + z * z);
    return {{1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)},
            {s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x)},
            {s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y)}};
}

/// v turned about a unit axis (O. Rodrigues 1840).
Real3 turned(const Real3& axis, Real angle, const Real3& v)
{
    const Real half = support::sine(angle / 2), sin = support::sine(angle);
    return v + sin * cross(axis, v) + (2 * half * half) * cross(axis, cross(axis, v));
}

Real3 farther(const Real3& a, const Real3& b, const Real3& d) { return dot(a, d) >= dot(b, d) ? a : b; }

Real3 support_of(const Sphere& s, const Real3& d) { return Real{s.radius} * direction(d); }
Real3 support_of(const Capsule& s, const Real3& d)
{
    return farther(real3(s.a), real3(s.b), d) + Real{s.radius} * direction(d);
}
Real3 support_of(const Box& s, const Real3& d)
{
    const Real3 h = real3(s.half_extents);
    return {std::copysign(h.x, d.x), std::copysign(h.y, d.y), std::copysign(h.z, d.z)};
}
Real3 support_of(const Triangle& s, const Real3& d)
{
    return farther(farther(real3(s.a), real3(s.b), d), real3(s.c), d);
}
Real3 support_of(const Cylinder& s, const Real3& d)
{
    return Real{s.radius} * direction(Real3{d.x, d.y, 0}) +
           Real3{0, 0, std::copysign(Real{s.half_length}, d.z)};
}
Real3 support_of(const Cone& s, const Real3& d)
{
    const Real h = s.half_length;
    return farther({0, 0, h}, Real{s.radius} * direction(Real3{d.x, d.y, 0}) - Real3{0, 0, h}, d);
}
Real3 support_of(const Ellipsoid& s, const Real3& d)
{
    const Real3 r = real3(s.radii), u = direction({r.x * d.x, r.y * d.y, r.z * d.z});
    return {r.x * u.x, r.y * u.y, r.z * u.z};
}
Real3 support_of(const Hull& s, const Real3& d)
{
    if (s.vertices().empty()) return {};
    Real3 best = real3(s.vertices()[0]);
    for (const Vec3& v : s.vertices())
        best = farther(best, real3(v), d);
    return best;
}
template <class Border> Real3 support_of(const Border&, const Real3&) { return {}; }

} // namespace

ExactMover::ExactMover(const Shape& shape, const Motion& m, const Real3& origin)
    : shape_(shape),
      axes_(matrix(m.start.orientation)),
      pivot_(real3(m.pivot)),
      from_(real3(m.start.position) - origin + axes_ * pivot_),
      by_(real3(m.translation)),
      axis_(direction(real3(m.rotation))),
      angle_(norm(real3(m.rotation)))
{
}

Real3 ExactMover::support(const Real3& d, Real t) const
{
    const Real3 local = transposed_times(axes_, turned(axis_, -t * angle_, d));
    const Real3 p = std::visit([&](const auto& s) { return support_of(s, local); }, shape_);
    return pivot(t) + turned(axis_, t * angle_, axes_ * (p - pivot_));
}

} // namespace brink::support
