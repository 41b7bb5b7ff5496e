// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "body_store.h"
#include "vector.h"

#include <vector>

/// Sorting bodies so that those that lie near each other come near each other.
namespace brink {

/// Slots to be sorted, and memory for it.
struct PlaceSorting {
    struct Key {
        std::uint32_t place, slot;
    };
    std::vector<Key> keys, other;
};

/// Orders the slots along a Z-order curve (G. Morton 1966) through where the pivots are half way.
void sort_by_place(PlaceSorting&, const BodyStore&);

/// A point from which differences to most bodies are not much larger than the scene: the present one if it
/// will do.
V3 origin_for(const BodyStore&, V3 present);

} // namespace brink
