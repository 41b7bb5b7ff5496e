// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mover.h"

#include <brink/toi.h>

namespace brink {

/// First contact of two moving shapes by certified advancement: at each pose the distance between them gives
/// an axis, and the axis a step over which they provably stay apart (B. Mirtich 1996; X. Zhang, M. Lee and Y.
/// Kim 2006). Inputs are already validated.
Toi certified_advancement(const Mover<Core>& a, const Mover<Core>& b, const Options&);
Toi certified_advancement(const Mover<Core>& a, const Mover<Border>& b, const Options&);

/// The same where contact at the start is already known.
Toi from_contact(const Mover<Core>& a, const Mover<Core>& b, const Options&);
Toi from_contact(const Mover<Core>& a, const Mover<Border>& b, const Options&);

/// Whether a pair of witness points shows contact at the start, rounding included.
bool proven_in_contact(const Mover<Core>& a, const Mover<Core>& b, const Options&);
bool proven_in_contact(const Mover<Core>& a, const Mover<Border>& b, const Options&);

/// Fills in the normal, points and gap at toi.t.
void describe_contact(Toi& toi, const Mover<Core>& a, const Mover<Core>& b, const Options&);
void describe_contact(Toi& toi, const Mover<Core>& a, const Mover<Border>& b, const Options&);

} // namespace brink
