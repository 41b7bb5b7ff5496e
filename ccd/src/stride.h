// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "certificate.h"

namespace brink {

/// An axis, and how long a step it proves.
struct Stride {
    TurningAxis axis;
    Step step;
};

/// The longest step that is found for an axis near this one, at rest or glued to either body. Where a step
/// ends, two points are in the way: among the axes that have them apart then, the next one is taken from the
/// midst. Bodies that hover at next to nothing leave the axis of the least distance no room to turn, while
/// one across the open side of what touches keeps its features apart for long. Of a plane there is one axis.
Stride stride(const Facing<Core>&, V3 normal, double horizon);
Stride stride(const Facing<Border>&, V3 normal, double horizon);

} // namespace brink
