// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/shape.h>
#include <random.h>

#include <btBulletCollisionCommon.h>

#include <memory>

namespace brink::bench {

/// One shape twice: brink's, of the floats that Bullet computes with, and Bullet's. Where Bullet adds its
/// collision margin outside (cones and hulls) that is 1 mm, and not in brink's.
struct Piece {
    Shape shape;
    std::unique_ptr<btCollisionShape> bullet;
    double volume = 0; // cubic metres, roughly; 0 of what never moves
};

/// Solid below z = 0.
Piece floor_piece();
Piece box_piece(const Vec3& half_extents);

/// A sphere, capsule, box, cylinder, cone or hull; the middles of its sides 4 to 25 cm away.
Piece stone(support::Random&);

/// A sphere, capsule, box, cylinder or hull, 2 mm to 10 cm from the middle: pellets, bolts, plates and
/// shards.
Piece projectile(support::Random&);

} // namespace brink::bench
