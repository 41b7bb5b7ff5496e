// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mover.h"

#include <brink/toi.h>

namespace brink {

/// What is already known about the start.
enum class Start : unsigned char {
    open,      // nothing
    in_contact // a closed form has decided that the gap is at most target_gap
};

/// First contact of two moving shapes by certified advancement: at each pose the distance between them gives
/// an axis, and the axis a step over which they provably stay apart (B. Mirtich 1996; X. Zhang, M. Lee and Y.
/// Kim 2006). Inputs are already validated.
Toi certified_advancement(const Mover<Core>& a, const Mover<Core>& b, const Options&, Start);
Toi certified_advancement(const Mover<Core>& a, const Mover<Border>& b, const Options&, Start);

} // namespace brink
