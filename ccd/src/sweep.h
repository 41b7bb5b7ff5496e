// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "block.h"
#include "vector.h"

#include <brink/scene.h>

/// What the broad phase keeps of a bounded body's motion. Valid shapes and motions only.
namespace brink {

/// With room for all rounding, and for the band of promise 3 (16 eps of all lengths) within which two bodies
/// may be called in contact.
Sweep sweep(const Body&, V3 origin);

/// How far a bounded shape reaches from its own origin; 0 for others.
double farthest_from_origin(const Shape&);

/// Where the pivot is half way, for sorting bodies by place.
V3 midway(const Body&);

/// The body's bounds where it stands at a pose.
Box3f standing(const Shape&, const Pose&, V3 origin);

/// x rounded outwards to float.
float round_down(double x);
float round_up(double x);

} // namespace brink
