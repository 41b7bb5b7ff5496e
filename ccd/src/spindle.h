// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "certificate.h"

namespace brink {

/// How long bodies stay in contact however often they turn, at most the horizon: a turn leaves every point of
/// its axis where it is, and with it the ball about it that lies within the body. Two such balls stay within
/// `reach` (the radii and the target gap) of each other, or one of them and a point that goes with the other
/// body; past the ends of the body there is still some point of it as far from there as it was. Of a plane or
/// half-space the normal goes round about its own axis. 0 where nothing is proven. Proof: numerics.md.
double spindle_step(const Facing<Core>&, double reach, double horizon);
double spindle_step(const Facing<Border>&, double reach, double horizon);

} // namespace brink
