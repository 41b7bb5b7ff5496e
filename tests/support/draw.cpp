// SPDX-License-Identifier: BSD-3-Clause
#include "draw.h"

#include <array>
#include <vector>

namespace brink::support {
namespace {

/// Rounded to 24 bits (T. Dekker 1971). Not by conversion to float and back, which g++ 12 drops from two
/// neighbours at -O2.
double in_float(double x)
{
    const double c = (0x1p29 + 1) * x;
    return c - (c - x);
}

Vec3 in_float(const Vec3& v) { return {in_float(v.x()), in_float(v.y()), in_float(v.z())}; }

Vec3 draw_axis(Random& random)
{
    const int k = random.index(3);
    Vec3 axis(0, 0, 0);
    axis[k] = random.chance(0.5) ? 1 : -1;
    return axis;
}

double quarters(Random& random, int n) { return 0.25 * random.index(n + 1); }

double draw_size(Random& random)
{
    const int kind = random.index(20);
    if (kind < 2) return 0;
    if (kind < 4) return random.log_between(1e-6, 1);
    return random.between(0.05, 1.2);
}

Vec3 draw_normal(Random& random, ShapeStyle style)
{
    if (style != ShapeStyle::any || random.chance(0.2)) return draw_axis(random);
    Vec3 normal = random.unit();
    const int kind = random.index(10);
    if (kind == 0) return in_float(normal);
    if (kind == 1) return (1 + random.between(-4e-7, 4e-7)) * normal;
    return normal;
}

Shape draw_sphere(Random& random, ShapeStyle style)
{
    if (style == ShapeStyle::integer) return Sphere{quarters(random, 8)};
    return Sphere{draw_size(random)};
}

Shape draw_capsule(Random& random, ShapeStyle style)
{
    if (style == ShapeStyle::integer) {
        const Vec3 a = draw_integers(random, 6);
        const double length = quarters(random, 8);
        const Vec3 axis = draw_axis(random);
        const Vec3 b = random.chance(0.5) ? Vec3(a + length * axis) : draw_integers(random, 6);
        return Capsule{a, b, quarters(random, 6)};
    }
    const double radius = 0.6 * draw_size(random);
    if (style == ShapeStyle::aligned) {
        const double half = draw_size(random);
        return Capsule{Vec3(-half, 0, 0), Vec3(half, 0, 0), radius};
    }
    const Vec3 a = random.in_cube(1);
    const Vec3 b = random.in_cube(1);
    const int kind = random.index(20);
    if (kind == 0) return Capsule{a, a, radius};
    if (kind == 1) return Capsule{a, a + random.log_between(1e-12, 1e-3) * b, radius};
    if (kind == 2) return Capsule{5 * a, 5 * b, 1e-6 * radius};
    return Capsule{a, b, radius};
}

Shape draw_box(Random& random, ShapeStyle style)
{
    if (style == ShapeStyle::integer) {
        const double x = quarters(random, 8);
        const double y = quarters(random, 8);
        const double z = quarters(random, 8);
        return Box{Vec3(x, y, z)};
    }
    const double x = draw_size(random);
    const double y = draw_size(random);
    const double z = draw_size(random);
    return Box{Vec3(x, y, z)};
}

Shape draw_triangle(Random& random, ShapeStyle style)
{
    if (style == ShapeStyle::integer) {
        const Vec3 a = draw_integers(random, 6);
        const Vec3 b = draw_integers(random, 6);
        const Vec3 c = draw_integers(random, 6);
        return Triangle{a, b, c};
    }
    Vec3 a = random.in_cube(1.3);
    Vec3 b = random.in_cube(1.3);
    Vec3 c = random.in_cube(1.3);
    if (style == ShapeStyle::aligned) {
        a.z() = b.z() = c.z() = 0;
        b.y() = a.y();
    }
    const int kind = random.index(24);
    const double s = random.between(-0.5, 1.5);
    if (kind == 0) return Triangle{a, a, a};
    if (kind == 1) return Triangle{a, b, a};
    if (kind == 2) return Triangle{a, b, a + s * (b - a)};
    if (kind == 3) return Triangle{a, b, a + s * (b - a) + random.log_between(1e-14, 1e-3) * c};
    return Triangle{a, b, c};
}

Shape draw_round(Random& random, std::size_t kind, ShapeStyle style)
{
    const bool whole = style == ShapeStyle::integer;
    const double half_length = whole ? quarters(random, 6) : draw_size(random);
    const double radius = whole ? quarters(random, 6) : draw_size(random);
    if (kind == 6) return Cylinder{half_length, radius};
    if (kind == 7) return Cone{half_length, radius};
    const double z = whole ? quarters(random, 6) : draw_size(random);
    return Ellipsoid{Vec3(half_length, radius, z)};
}

/// What a point of a hull is drawn from.
enum class Cloud : unsigned char { ball, sphere, grid, flat, line, needle };

Vec3 draw_in_cloud(Random& random, Cloud cloud)
{
    Vec3 p = random.in_cube(1);
    if (cloud == Cloud::sphere) return random.unit();
    if (cloud == Cloud::grid) return draw_integers(random, 4);
    if (cloud == Cloud::flat) p.z() = 0.25;
    if (cloud == Cloud::line) p = Vec3(p.x(), p.x(), p.x());
    if (cloud == Cloud::needle) p = Vec3(p.x(), 1e-5 * p.y(), 1e-5 * p.z());
    return p;
}

Shape draw_hull(Random& random, ShapeStyle style)
{
    constexpr std::array<int, 8> counts{1, 2, 3, 4, 5, 12, 40, 150};
    const int count = counts[static_cast<std::size_t>(random.index(static_cast<int>(counts.size())))];
    const auto any = static_cast<Cloud>(random.index(6));
    const bool thin = random.chance(0.5);
    Cloud cloud = any >= Cloud::flat && thin ? Cloud::ball : any;
    if (style == ShapeStyle::integer) cloud = Cloud::grid;
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i)
        points.push_back(draw_in_cloud(random, cloud));
    return Hull::from_points(points);
}

} // namespace

Vec3 draw_integers(Random& random, int n)
{
    const double x = 0.25 * (random.index(2 * n + 1) - n);
    const double y = 0.25 * (random.index(2 * n + 1) - n);
    const double z = 0.25 * (random.index(2 * n + 1) - n);
    return {x, y, z};
}

Shape draw_shape(Random& random, std::size_t kind, ShapeStyle style)
{
    if (kind == 0) return draw_sphere(random, style);
    if (kind == 1) return draw_capsule(random, style);
    if (kind == 2) return draw_box(random, style);
    if (kind == 3) return draw_triangle(random, style);
    if (kind >= 6 && kind < 9) return draw_round(random, kind, style);
    if (kind == 9) return draw_hull(random, style);
    const Vec3 normal = draw_normal(random, style);
    const double offset = style == ShapeStyle::integer ? draw_integers(random, 8).x() : random.between(-1, 1);
    if (kind == 4) return Plane{normal, offset};
    return HalfSpace{normal, offset};
}

Shape small_shape(Random& random, std::size_t kind)
{
    const double size = random.log_between(0.002, 0.05);
    const Vec3 a = size * random.in_cube(1);
    const Vec3 b = size * random.in_cube(1);
    const Vec3 c = size * random.in_cube(1);
    if (kind == 0) return Sphere{size};
    if (kind == 1) return Capsule{a, b, 0.5 * size};
    if (kind == 2) return Box{a.cwiseAbs()};
    if (kind == 3) return Triangle{a, b, c};
    if (kind == 6) return Cylinder{size, 0.5 * size};
    if (kind == 7) return Cone{size, 0.5 * size};
    if (kind == 8) return Ellipsoid{a.cwiseAbs()};
    if (kind == 9) return Hull::from_points(std::array<Vec3, 4>{a, b, c, Vec3(size, 0, 0)});
    return draw_shape(random, kind, ShapeStyle::any);
}

Box thin_wall(Random& random)
{
    Vec3 half(1.5, 1.5, 1.5);
    half[random.index(3)] = 0.005;
    return Box{half};
}

Quat draw_orientation(Random& random)
{
    Quat turned = random.rotation();
    const int kind = random.index(10);
    if (kind < 2) return {1, 0, 0, 0};
    if (kind == 2) {
        constexpr double half = 0.70710678118654752;
        const Vec3 axis = draw_axis(random);
        return {half, half * axis.x(), half * axis.y(), half * axis.z()};
    }
    if (kind == 3)
        return {in_float(turned.w()), in_float(turned.x()), in_float(turned.y()), in_float(turned.z())};
    if (kind == 4) {
        const double s = 1 + random.between(-4e-7, 4e-7);
        return {s * turned.w(), s * turned.x(), s * turned.y(), s * turned.z()};
    }
    return turned;
}

Quat turned_by(const Quat& q, const Vec3& turn)
{
    // q times (1, turn / 2), normalised.
    const Vec3 half = 0.5 * turn;
    const double w = q.w() - (q.x() * half.x() + q.y() * half.y() + q.z() * half.z());
    const double x = q.x() + q.w() * half.x() + (q.y() * half.z() - q.z() * half.y());
    const double y = q.y() + q.w() * half.y() + (q.z() * half.x() - q.x() * half.z());
    const double z = q.z() + q.w() * half.z() + (q.x() * half.y() - q.y() * half.x());
    const double length = std::sqrt(w * w + x * x + y * y + z * z);
    return {w / length, x / length, y / length, z / length};
}

Quat nearly(Random& random, const Quat& q)
{
    const double angle = random.log_between(1e-14, 1e-1);
    const Vec3 turn = angle * random.unit();
    return random.chance(0.3) ? q : turned_by(q, turn);
}

} // namespace brink::support
