// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "toi_query.h"

#include <optional>

namespace brink {

/// Whether two shapes are within target_gap of each other at the start, with nothing rounded: for where
/// double arithmetic leaves that in doubt. Of a cylinder, cone or ellipsoid a polytope inside stands for all
/// of it, so only contact is told. Nothing where that leaves it open, or where the numbers reach over too
/// many powers of two. Both shapes are valid and in the table's order. A tenth of a millisecond; no heap.
std::optional<bool> in_contact_at_start(const Query&);

} // namespace brink
