// SPDX-License-Identifier: BSD-3-Clause
#include "reference.h"

#include <algorithm>
#include <limits>

namespace brink::support {
namespace {

/// exp(angle [axis]x), Rodrigues with 1 - cos as 2 sin^2 of the half.
Real33 turned(const Real3& axis, Real angle)
{
    const Real s = sine(angle);
    const Real h = sine(angle / 2);
    const auto column = [&](const Real3& v) {
        const Real3 av = cross(axis, v);
        return v + s * av + (2 * h * h) * cross(axis, av);
    };
    return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})};
}

/// How far from the pivot the shape's core reaches: of a solid, a box around it.
Real reach(const Shape& shape, const Real3& pivot)
{
    const Placed local = place(shape, RealPose{-pivot, {}});
    Real farthest = 0;
    for (std::size_t i = 0; i < local.corner_count; ++i)
        farthest = std::max(farthest, norm(local.corners[i]));
    if (local.kind != Placed::Kind::solid) return farthest;
    for (const Vector<Real>& corner : local.solid->corners)
        farthest = std::max(farthest, norm(Real3{corner.x, corner.y, corner.z} - pivot));
    return farthest;
}

Real extent(const Shape& shape, const Real3& pivot)
{
    const Placed local = place(shape, {});
    return local.radius + norm(pivot) + (local.unbounded() ? std::abs(local.offset) : reach(shape, {}));
}

bool unbounded(const Shape& shape)
{
    return std::holds_alternative<Plane>(shape) || std::holds_alternative<HalfSpace>(shape);
}

} // namespace

RealPose GapOverTime::Body::at(Real t) const
{
    const Real33 now = turn == 0 ? orientation : turned(axis, t * turn) * orientation;
    return {pivot + t * translation - now * pivot_local, now};
}

Real3 GapOverTime::Body::velocity(Real t, const Real3& point) const
{
    return translation + turn * cross(axis, point - (pivot + t * translation));
}

GapOverTime::Body GapOverTime::body(const Shape& shape, const Motion& motion, const Real3& origin)
{
    Body out;
    out.orientation = rotation_matrix(motion.start.orientation);
    out.pivot_local = real3(motion.pivot);
    out.pivot = (real3(motion.start.position) - origin) + out.orientation * out.pivot_local;
    out.translation = real3(motion.translation);
    out.turn = norm(real3(motion.rotation));
    out.axis = direction(real3(motion.rotation));
    out.reach = reach(shape, out.pivot_local);
    return out;
}

GapOverTime::GapOverTime(const Query& query)
    : shape_a_(query.a),
      shape_b_(query.b),
      origin_(real3(query.motion_b.start.position)),
      a_(body(query.a, query.motion_a, origin_)),
      b_(body(query.b, query.motion_b, origin_))
{
    const Real3 apart = b_.pivot - a_.pivot;
    const Real3 by = b_.translation - a_.translation;
    // An unbounded body sweeps past the other at the other's distance from its pivot, greatest at an end of
    // the step.
    const Real span = std::max(norm(apart), norm(apart + by));
    if (unbounded(query.a)) a_.reach = span + b_.reach;
    if (unbounded(query.b)) b_.reach = span + a_.reach;
    fastest_ = norm(by) + a_.turn * a_.reach + b_.turn * b_.reach;
    bend_ = a_.turn * a_.turn * a_.reach + b_.turn * b_.turn * b_.reach;
    if (unbounded(query.a)) bend_ += 2 * a_.turn * (norm(by) + b_.turn * b_.reach);
    if (unbounded(query.b)) bend_ += 2 * b_.turn * (norm(by) + a_.turn * a_.reach);
    // What an unbounded body that turns extends to is where it can be met.
    const auto swept = [](const Shape& shape, const Body& b) {
        return unbounded(shape) ? b.turn * b.reach : 0;
    };
    scale_ = swept(query.a, a_) + swept(query.b, b_) + norm(real3(query.motion_a.start.position) - origin_) +
             norm(by) + (1 + a_.turn) * extent(query.a, a_.pivot_local) +
             (1 + b_.turn) * extent(query.b, b_.pivot_local) + static_cast<Real>(query.options.target_gap);
}

Gap GapOverTime::at(Real t) const { return gap(placed_a(t), placed_b(t)); }

Real GapOverTime::Line::least(Real tau) const
{
    const Real3 along = normal + tau * turning;
    const Real3 lowest = core.unbounded() ? Real3{} : farthest(core, -along);
    return base + tau * rate + dot(along, lowest) - core.radius;
}

/// Along the normal for B, and against it for A, so that the two least heights add up to the separation.
GapOverTime::Line GapOverTime::line(Real t, const Gap& here, Side side) const
{
    const bool of_a = side == Side::a;
    const Body& moving = of_a ? a_ : b_;
    const Body& base = of_a ? b_ : a_;
    const Real3 n = of_a ? -here.normal : here.normal;
    Line out;
    out.core = of_a ? placed_a(t) : placed_b(t);
    if (out.core.unbounded()) {
        out.base = dot(n, (of_a ? here.point_a : here.point_b) - here.point_a);
        return out;
    }
    out.normal = n;
    out.base = -dot(n, here.point_a);
    out.turning = cross(n, moving.turn * moving.axis);
    out.rate = dot(n, moving.velocity(t, Real3{}));
    if (!unbounded(of_a ? shape_b_ : shape_a_)) return out;
    out.turning = out.turning - cross(n, base.turn * base.axis);
    out.rate -= dot(n, base.velocity(t, Real3{}));
    return out;
}

Real GapOverTime::safe_step(Real t, const Gap& here, Real level, Real most) const
{
    const Real by_speed = fastest_ > 0 ? std::min(most, (here.gap - level) / fastest_) : most;
    const Line a = line(t, here, Side::a);
    const Line b = line(t, here, Side::b);
    // Separation along a normal fixed in the world, or in the unbounded body, is at least this. It is concave
    // in tau: where it is above `level` at tau, it is before tau too.
    const auto separation = [&](Real tau) { return a.least(tau) + b.least(tau) - bend_ * tau * tau / 2; };
    if (separation(most) > level) return most;
    Real safe = 0;
    Real unsafe = most;
    for (int i = 0; i < 70 && unsafe - safe > safe * 1e-3L; ++i) {
        const Real middle = (safe + unsafe) / 2;
        (separation(middle) > level ? safe : unsafe) = middle;
    }
    return std::max(safe, by_speed);
}

} // namespace brink::support
