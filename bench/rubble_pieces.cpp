// SPDX-License-Identifier: BSD-3-Clause
#include "rubble_pieces.h"

#include <cmath>
#include <vector>

namespace brink::bench {
namespace {

using support::Random;

constexpr float outer_margin = 0.001F; // metres

/// A piece's volume as a share of its bounds', roughly: that of an ellipsoid.
constexpr double fill = 0.5;

/// Both libraries have the same lengths: whole micrometres or so, exact in float. (To convert to float and
/// back would not do: g++ 12 leaves that out where it converts two at a time, GCC 12.2 -O2.)
double exact_in_float(double length) { return std::ldexp(std::floor(std::ldexp(length, 20)), -20); }

float draw(Random& random, double least, double most)
{
    return static_cast<float>(exact_in_float(random.log_between(least, most)));
}

template <class Bullet> Piece piece(const Shape& shape, std::unique_ptr<Bullet> bullet)
{
    btVector3 low, high;
    bullet->getAabb(btTransform::getIdentity(), low, high);
    const btVector3 size = high - low;
    const double volume =
        fill * static_cast<double>(size.x()) * static_cast<double>(size.y()) * static_cast<double>(size.z());
    return {shape, std::move(bullet), volume};
}

Piece sphere(float radius) { return piece(Sphere{radius}, std::make_unique<btSphereShape>(radius)); }

Piece capsule(float half_length, float radius)
{
    const Vec3 end(0, 0, half_length);
    return piece(Capsule{-end, end, radius}, std::make_unique<btCapsuleShapeZ>(radius, 2 * half_length));
}

Piece box(float x, float y, float z)
{
    return piece(Box{{x, y, z}}, std::make_unique<btBoxShape>(btVector3(x, y, z)));
}

Piece cylinder(float half_length, float radius)
{
    return piece(Cylinder{half_length, radius},
                 std::make_unique<btCylinderShapeZ>(btVector3(radius, radius, half_length)));
}

Piece cone(float half_length, float radius)
{
    auto bullet = std::make_unique<btConeShapeZ>(radius, 2 * half_length);
    bullet->setMargin(outer_margin);
    return piece(Cone{half_length, radius}, std::move(bullet));
}

/// Points on an ellipsoid about the origin, which is taken for the centre of mass.
Piece hull(Random& random, int count, const Vec3& radii)
{
    std::vector<Vec3> points;
    auto bullet = std::make_unique<btConvexHullShape>();
    for (int i = 0; i < count; ++i) {
        const Vec3 p = radii.cwiseProduct(random.unit()).unaryExpr(&exact_in_float);
        const Eigen::Vector3f same = p.cast<float>();
        points.push_back(p);
        bullet->addPoint(btVector3(same.x(), same.y(), same.z()), false);
    }
    bullet->recalcLocalAabb();
    bullet->setMargin(outer_margin);
    return piece(Hull::from_points(points), std::move(bullet));
}

Vec3 draw_radii(Random& random, double least, double most)
{
    const double x = random.log_between(least, most);
    const double y = random.log_between(least, most);
    const double z = random.log_between(least, most);
    return {x, y, z};
}

} // namespace

Piece floor_piece()
{
    return {HalfSpace{}, std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), btScalar(0)), 0};
}

Piece box_piece(const Vec3& h)
{
    const Eigen::Vector3f same = h.unaryExpr(&exact_in_float).cast<float>();
    return box(same.x(), same.y(), same.z());
}

Piece stone(Random& random)
{
    constexpr double least = 0.04, most = 0.25;
    const int kind = random.index(6);
    const float x = draw(random, least, most);
    const float y = draw(random, least, most);
    const float z = draw(random, least, most);
    if (kind == 0) return sphere(x);
    if (kind == 1) return capsule(x / 2, y / 2);
    if (kind == 2) return box(x, y, z);
    if (kind == 3) return cylinder(x, y);
    if (kind == 4) return cone(x, y);
    const int points = 8 + random.index(17);
    const Vec3 radii = draw_radii(random, 1.2 * least, most);
    return hull(random, points, radii);
}

Piece projectile(Random& random)
{
    const int kind = random.index(5);
    const float thin = draw(random, 0.002, 0.01);
    const float middle = draw(random, 0.005, 0.04);
    const float wide = draw(random, 0.01, 0.1);
    if (kind == 0) return sphere(random.chance(0.5) ? middle : wide);
    if (kind == 1) return capsule(wide, thin);
    if (kind == 2) return box(thin, middle, wide);
    if (kind == 3) return cylinder(wide, thin);
    const int points = 6 + random.index(7);
    const Vec3 radii = draw_radii(random, 0.008, 0.06);
    return hull(random, points, radii);
}

} // namespace brink::bench
