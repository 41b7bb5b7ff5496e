// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "crossing.h"

namespace brink::bench {

/// A straight rod spins about a point of itself, its middle or another, and strikes a thin post that stands
/// along the axis of the spin.
Crossing rod_at_post(support::Random&, double speed);

/// A thin blade on a hinge beyond its end strikes a small ball.
Crossing blade_at_ball(support::Random&, double speed);

/// A thin box, thrown at a wall, spins about its centre and strikes with a corner.
Crossing box_at_wall(support::Random&, double speed);

/// The same with given half extents, striking with an edge: it spins about its own z axis, which is the
/// wall's too, so that a section across z shows all there is. The wall's big faces are those across its x.
Crossing box_at_wall_in_section(support::Random&, const Vec3& half_extents, double speed);

} // namespace brink::bench
