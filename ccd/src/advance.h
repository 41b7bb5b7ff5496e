// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mover.h"
#include "toi_query.h"

#include <brink/toi.h>

#include <optional>

namespace brink {

/// Who knows, to the last bit, whether a query begins in contact, for where rounding cannot tell; or does not
/// know.
struct StartOracle {
    const Query& query;                                        // in the caller's lengths
    std::optional<bool> (*in_contact)(const Query&) = nullptr; // none: nobody
};

/// First contact of two moving shapes by certified advancement: at each pose the distance between them gives
/// an axis, and the axis a step over which they provably stay apart (B. Mirtich 1996; X. Zhang, M. Lee and Y.
/// Kim 2006). Inputs are already validated. Part is Core or Border. `spent` distance evaluations are counted
/// already.
template <class Part>
Toi certified_advancement(const Mover<Core>& a, const Mover<Part>& b, const Options&, const StartOracle&,
                          int spent = 0);

/// The same where contact at the start is already known.
template <class Part> Toi from_contact(const Mover<Core>& a, const Mover<Part>& b, const Options&);

/// The same where a pair of witness points proves contact at the start, rounding included; else empty.
template <class Part>
std::optional<Toi> from_proven_contact(const Mover<Core>& a, const Mover<Part>& b, const Options&);

/// Fills in the normal, points and gap at toi.t.
template <class Part>
void describe_contact(Toi& toi, const Mover<Core>& a, const Mover<Part>& b, const Options&);

} // namespace brink
