// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector.h"

#include <array>
#include <vector>

namespace brink {

/// A triangle between three of some points, by their places in the list.
using Facet = std::array<int, 3>;

/// What may be the faces of the hull of some points, none outside of the cube of half edge 2. Nothing about
/// it is sure. Empty where there is no proposal.
std::vector<Facet> proposed_faces(const std::vector<V3>& points);

} // namespace brink
