// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/shape.h>
#include <brink/status.h>

namespace brink {

/// Where a ray first meets a shape.
struct RayHit {
    Status status = Status::invalid; // invalid, separated, touching (the origin lies in the shape) or hit
    double t = 0;                    // in lengths of `direction`; 0 when touching, t_max when separated
    Vec3 point{0, 0, 0};             // world, on the shape
    Vec3 normal{0, 0, 0};            // unit, world, out of the shape towards the ray; zero when separated
};

/// First point of origin + t * direction, t in [0, t_max], that lies in the posed shape. `direction` need not
/// be a unit vector; a zero direction asks about the origin alone. t_max >= 0 and may be infinite.
RayHit ray_cast(const Vec3& origin, const Vec3& direction, const Shape&, const Pose&, double t_max = 1);

} // namespace brink
