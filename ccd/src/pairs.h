// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "approach.h"

#include <brink/shape.h>

/// Every pair of shapes whose first contact under translation has a closed form: no iteration, no tolerance.
/// Inputs are already validated. Each returns the first t >= 0, however late.
namespace brink {

Entry sphere_sphere(const Sphere&, const Sphere&, const Approach&);
Entry sphere_capsule(const Sphere&, const Capsule&, const Approach&);
Entry sphere_box(const Sphere&, const Box&, const Approach&);
Entry sphere_triangle(const Sphere&, const Triangle&, const Approach&);
Entry sphere_plane(const Sphere&, const Plane&, const Approach&);
Entry sphere_half_space(const Sphere&, const HalfSpace&, const Approach&);
Entry capsule_capsule(const Capsule&, const Capsule&, const Approach&);
Entry capsule_box(const Capsule&, const Box&, const Approach&);
Entry capsule_triangle(const Capsule&, const Triangle&, const Approach&);
Entry box_box(const Box&, const Box&, const Approach&);
Entry capsule_plane(const Capsule&, const Plane&, const Approach&);
Entry capsule_half_space(const Capsule&, const HalfSpace&, const Approach&);

} // namespace brink
