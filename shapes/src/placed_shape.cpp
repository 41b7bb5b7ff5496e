// SPDX-License-Identifier: BSD-3-Clause
#include "placed_shape.h"

#include "scaling.h"
#include "validity.h"

namespace brink {

namespace {

/// Coordinates times 2^headroom can be added and subtracted without overflow.
constexpr int headroom = -6;

Separation separation(const PlacedShape& a, const PlacedShape& b)
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
    if (const auto* s = std::get_if<Cylinder>(&shape)) return {true, core(*s), {}};
    if (const auto* s = std::get_if<Cone>(&shape)) return {true, core(*s), {}};
    if (const auto* s = std::get_if<Ellipsoid>(&shape)) return {true, core(*s), {}};
    if (const auto* s = std::get_if<Hull>(&shape)) return {true, core(*s), {}};
    return {false, {}, {}};
}

} // namespace

PlacedShape placed_shape(const Shape& shape, const Pose& pose, V3 origin, int exponent)
{
    const Rotation turn = rotation(pose.orientation);
    const V3 position = scaled(load(pose.position), exponent) - scaled(origin, exponent);
    const Local l = local(shape);
    if (l.bounded) return {true, placed(scaled(l.core, exponent), turn, position), {}};
    return {false, {}, placed(scaled(l.border, exponent), turn, position)};
}

std::optional<Separation> separation(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b)
{
    if (unbounded(a) && unbounded(b)) return {};
    const V3 origin = load(unbounded(a) ? pose_b.position : pose_a.position);
    int e = 0;
    Separation s = separation(placed_shape(a, pose_a, origin), placed_shape(b, pose_b, origin));
    if (!is_finite(s.point_a) || !is_finite(s.point_b)) {
        e = headroom;
        s = separation(placed_shape(a, pose_a, origin, e), placed_shape(b, pose_b, origin, e));
    }
    const auto out = [&](V3 p) { return scaled(p + scaled(origin, e), -e); };
    return Separation{std::ldexp(s.lower, -e), std::ldexp(s.gap, -e), s.normal, out(s.point_a),
                      out(s.point_b)};
}

} // namespace brink
