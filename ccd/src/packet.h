// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "search.h"

namespace brink {

/// The bodies of a leaf, grown by what counts as meeting and cut off at the time that still matters.
void make_packet(Packet&, const BlockTree&, std::uint32_t leaf, const Plan&);

/// One sweep alone, grown likewise.
Packet packet_of(const Sweep&, const Plan&);

/// Takes out of a chunk's candidates, and counts, those that rest, masks or the filter settle.
void drop_what_need_not_be_asked(Chunk&, const BodyStore&, const Plan&);

/// Whether such a pair meets at all, whatever layers are switched off.
bool meets(const Candidate&, const BodyStore&, const Plan&);

} // namespace brink
