// SPDX-License-Identifier: BSD-3-Clause
#include "body.h"

#include "validity.h"

namespace brink {

namespace {

/// Coordinates this much smaller can be added and subtracted without overflow.
constexpr double headroom = 0x1p-6;

Core scaled(Core c, double factor)
{
    for (int k = 0; k < c.count; ++k)
        c.points[k] = factor * c.points[k];
    c.radius *= factor;
    c.centre = factor * c.centre;
    c.half_extents = factor * c.half_extents;
    return c;
}

Border scaled(Border b, double factor)
{
    b.offset *= factor;
    return b;
}

Separation separation(const Body& a, const Body& b)
{
    if (!a.bounded) return flipped(separation(b.core, a.border));
    return b.bounded ? separation(a.core, b.core) : separation(a.core, b.border);
}

struct Local {
    bool bounded;
    Core core;
    Border border;
};

Local local(const Shape& shape)
{
    if (const auto* s = std::get_if<Sphere>(&shape)) return {true, core(*s), {}};
    if (const auto* s = std::get_if<Capsule>(&shape)) return {true, core(*s), {}};
    if (const auto* s = std::get_if<Box>(&shape)) return {true, core(*s), {}};
    if (const auto* s = std::get_if<Triangle>(&shape)) return {true, core(*s), {}};
    if (const auto* s = std::get_if<Plane>(&shape)) return {false, {}, border(*s)};
    if (const auto* s = std::get_if<HalfSpace>(&shape)) return {false, {}, border(*s)};
    return {false, {}, {}};
}

} // namespace

Body body(const Shape& shape, const Pose& pose, V3 origin, double factor)
{
    const Rotation turn = rotation(pose.orientation);
    const V3 position = factor * load(pose.position) - factor * origin;
    const Local l = local(shape);
    if (l.bounded) return {true, placed(scaled(l.core, factor), turn, position), {}};
    return {false, {}, placed(scaled(l.border, factor), turn, position)};
}

std::optional<Separation> separation(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b)
{
    if (unbounded(a) && unbounded(b)) return {};
    const V3 origin = load(unbounded(a) ? pose_b.position : pose_a.position);
    double factor = 1;
    Separation s = separation(body(a, pose_a, origin), body(b, pose_b, origin));
    if (!is_finite(s.point_a) || !is_finite(s.point_b)) {
        factor = headroom;
        s = separation(body(a, pose_a, origin, factor), body(b, pose_b, origin, factor));
    }
    const auto out = [&](V3 p) { return (1 / factor) * (p + factor * origin); };
    return Separation{s.lower / factor, s.gap / factor, s.normal, out(s.point_a), out(s.point_b)};
}

} // namespace brink
