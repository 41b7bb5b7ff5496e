// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "certificate.h"

namespace brink {

/// The time, at most the horizon, over which bodies in contact provably stay so: 0 where nothing is proven.
/// `contact` tells of the shapes where they are now, `reach` is the sum of the radii and the target gap. Two
/// points that go with their bodies stay within `reach` of each other, one of them inside the other core, or
/// four pairs of points about a point of both. Proof: numerics.md.
double contact_step(const Facing<Core>&, const Separation& contact, double reach, double horizon);
double contact_step(const Facing<Border>&, const Separation& contact, double reach, double horizon);

} // namespace brink
