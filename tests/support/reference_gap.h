// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bracket.h"
#include "real.h"

#include <array>
#include <memory>

namespace brink::support {

/// world = position + orientation * local, in the frame the caller chose.
struct RealPose {
    Real3 position;
    Real33 orientation;
};

/// The rotation M(q) / |q|^2 that a quaternion stands for.
Real33 rotation_matrix(const Quat&);

/// A placed shape as the reference sees it: the hull of at most eight corners, grown by a radius; an
/// unbounded one; or a `solid` (cylinder, cone, ellipsoid, hull), which has no corners here.
struct Placed {
    enum class Kind : unsigned char { point, segment, triangle, box, plane, half_space, solid };
    Kind kind = Kind::point;
    Real radius = 0;
    std::array<Real3, 8> corners{}; // of a box: bit k of the index is the side along axis k
    std::size_t corner_count = 0;
    Real3 centre;    // box
    Real33 axes;     // box
    Real3 half;      // box
    Real3 normal;    // plane, half-space: unit
    Real offset = 0; // plane, half-space
    std::shared_ptr<const Solid<Real>> solid;
    Placement<Real> placement; // of the solid
    bool unbounded() const { return kind == Kind::plane || kind == Kind::half_space; }
};

Placed place(const Shape&, const RealPose&);

/// A point of a bounded core that is farthest along n.
Real3 farthest(const Placed&, const Real3& n);

/// The signed gap and where it is taken. When cores overlap the points are corners' projections of no
/// meaning, and `points_known` is false.
struct Gap {
    Real gap = 0;
    Real3 normal; // unit, from A to B; of the least penetration when they overlap
    Real3 point_a, point_b;
    bool points_known = false;
};

/// By brute force over features: every edge against every edge, every corner against every face, piercing by
/// edges, penetration by separating axes; with a `solid`, by bracket(), which knows no depth. Radii are added
/// to the cores' answer. At most one shape may be unbounded.
Gap gap(const Placed& a, const Placed& b);

/// Distance from a point to a shape's solid; negative inside.
Real gap_to_point(const Placed& shape, const Real3& point);

} // namespace brink::support
