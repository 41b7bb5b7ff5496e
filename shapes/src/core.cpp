// SPDX-License-Identifier: BSD-3-Clause
#include "core.h"

namespace brink {

namespace {

void place_corners(Core& box)
{
    const V3 x = box.half_extents.x * box.axes.x;
    const V3 y = box.half_extents.y * box.axes.y;
    const V3 z = box.half_extents.z * box.axes.z;
    const V3 left = box.centre - x, right = box.centre + x;
    const V3 sides[4] = {left - y, right - y, left + y, right + y};
    for (int k = 0; k < 4; ++k) {
        box.points[k] = sides[k] - z;
        box.points[k + 4] = sides[k] + z;
    }
}

/// The border with its normal made a unit vector, which leaves the set as it is.
Border unit_border(V3 normal, double offset, bool solid)
{
    const double length = norm(normal);
    return {{normal.x / length, normal.y / length, normal.z / length}, offset / length, solid};
}

} // namespace

Core core(const Sphere& sphere)
{
    Core c;
    c.radius = sphere.radius;
    return c;
}

Core core(const Capsule& capsule)
{
    Core c;
    c.kind = Core::Kind::segment;
    c.count = 2;
    c.points[0] = load(capsule.a);
    c.points[1] = load(capsule.b);
    c.radius = capsule.radius;
    return c;
}

Core core(const Box& box)
{
    Core c;
    c.kind = Core::Kind::box;
    c.count = 8;
    c.half_extents = load(box.half_extents);
    place_corners(c);
    return c;
}

Core core(const Triangle& triangle)
{
    Core c;
    c.kind = Core::Kind::triangle;
    c.count = 3;
    c.points[0] = load(triangle.a);
    c.points[1] = load(triangle.b);
    c.points[2] = load(triangle.c);
    return c;
}

Core placed(const Core& local, const Rotation& rotation, V3 position)
{
    Core c;
    c.kind = local.kind;
    c.count = local.count;
    c.radius = local.radius;
    if (local.kind == Core::Kind::box) {
        c.centre = rotation * local.centre + position;
        c.half_extents = local.half_extents;
        c.axes = rotation * local.axes;
        place_corners(c);
        return c;
    }
    // A sphere about its origin: its orientation was never looked at, and may be anything.
    if (local.kind == Core::Kind::point && local.points[0] == V3{}) {
        c.points[0] = position;
        return c;
    }
    for (int k = 0; k < local.count; ++k)
        c.points[k] = rotation * local.points[k] + position;
    return c;
}

Border border(const Plane& plane) { return unit_border(load(plane.normal), plane.offset, false); }
Border border(const HalfSpace& space) { return unit_border(load(space.normal), space.offset, true); }

Border placed(const Border& local, const Rotation& rotation, V3 position)
{
    const V3 normal = rotation * local.normal;
    return {normal, local.offset + dot(normal, position), local.solid};
}

} // namespace brink
