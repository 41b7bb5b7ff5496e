// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "search.h"

namespace brink {

/// A packet against the planes and half-spaces of the scene, from item.next on. Returns which of them there
/// was no room for, or no_leaf.
std::uint32_t unbounded_candidates(const Packet&, const Item&, const BodyStore&, const BroadPhase&,
                                   const Plan&, Candidates&, JoinCounts&);

} // namespace brink
