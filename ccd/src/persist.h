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

/// How deep an overlap is to stay, from now on.
struct Kept {
    double depth = 0; // how far one core must at least be moved to part them
    double rate = 0;  // how fast that may become less
};
/// As long as cores that overlap do so and as deep as is to be kept, by three pairs of points about where the
/// way out is the shortest, and one pair far from there.
double overlap_step(const Facing<Core>&, const Separation& contact, const Kept&, double horizon);

} // namespace brink
