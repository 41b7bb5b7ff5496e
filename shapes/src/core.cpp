// SPDX-License-Identifier: BSD-3-Clause
#include "core.h"

#include "hull_data.h"
#include "scaling.h"

namespace brink {

namespace {

/// A core that is where its centre and axes are.
Core solid(Core::Kind kind, int count, V3 half_extents)
{
    Core c;
    c.kind = kind;
    c.count = count;
    c.half_extents = half_extents;
    return c;
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

Core core(const Box& box) { return solid(Core::Kind::box, 8, load(box.half_extents)); }

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

Core core(const Cylinder& c) { return solid(Core::Kind::cylinder, 0, {c.radius, c.radius, c.half_length}); }
Core core(const Cone& c) { return solid(Core::Kind::cone, 0, {c.radius, c.radius, c.half_length}); }
Core core(const Ellipsoid& e) { return solid(Core::Kind::ellipsoid, 0, load(e.radii)); }

Core core(const Hull& hull)
{
    Core c;
    if (hull.data() == nullptr) return c;
    const HullData& data = *hull.data();
    const double unit = data.unit;
    c.count = data.count;
    if (c.count <= 3) {
        constexpr Core::Kind kinds[] = {Core::Kind::point, Core::Kind::segment, Core::Kind::triangle};
        c.kind = kinds[c.count - 1];
        for (int k = 0; k < c.count; ++k)
            c.points[k] = load(data.vertices[static_cast<std::size_t>(k)]);
        return c;
    }
    c.kind = Core::Kind::hull;
    c.axes = {{unit, 0, 0}, {0, unit, 0}, {0, 0, unit}};
    c.hull = &data;
    expect(data.corners);
    return c;
}

Core placed(const Core& local, const Rotation& rotation, V3 position)
{
    Core c = local;
    // A sphere about its origin: its orientation was never looked at, and may be anything.
    if (local.kind == Core::Kind::point && local.points[0] == V3{}) {
        c.points[0] = position;
    } else if (local.kind <= Core::Kind::triangle) {
        for (int k = 0; k < local.count; ++k)
            c.points[k] = rotation * local.points[k] + position;
    } else {
        c.centre = rotation * local.centre + position;
        c.axes = rotation * local.axes;
    }
    return c;
}

Core scaled(const Core& core, int exponent)
{
    if (exponent == 0) return core;
    Core c = core;
    for (V3& point : c.points)
        point = scaled(point, exponent);
    c.radius = std::ldexp(c.radius, exponent);
    c.centre = scaled(c.centre, exponent);
    c.half_extents = scaled(c.half_extents, exponent);
    if (c.kind == Core::Kind::hull)
        c.axes = {scaled(c.axes.x, exponent), scaled(c.axes.y, exponent), scaled(c.axes.z, exponent)};
    return c;
}

Border border(const Plane& plane) { return unit_border(load(plane.normal), plane.offset, false); }
Border border(const HalfSpace& space) { return unit_border(load(space.normal), space.offset, true); }

Border placed(const Border& local, const Rotation& rotation, V3 position)
{
    const V3 normal = rotation * local.normal;
    return {normal, local.offset + dot(normal, position), local.solid};
}

Border scaled(const Border& border, int exponent)
{
    return {border.normal, std::ldexp(border.offset, exponent), border.solid};
}

} // namespace brink
