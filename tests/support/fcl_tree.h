// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/aabb.h>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace brink::support {

/// The pairs of boxes that overlap by FCL's DynamicAABBTreeCollisionManager, the lower index first, in order.
/// All boxes finite.
std::vector<std::pair<std::uint32_t, std::uint32_t>> fcl_overlapping(std::span<const Aabb>);

} // namespace brink::support
