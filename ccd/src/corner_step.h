// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "certificate.h"

namespace brink {

/// What safe_step proves, corner by corner: each bends away from its own line no more than its own distance
/// from the pivot lets it. Far longer where a body rocks on a corner that stays near the other one, and as
/// much work as there are corners. The axis of a plane or half-space is its own, with its rate.
template <class Part> Step corner_step(const Facing<Part>&, const TurningAxis&, double horizon);

} // namespace brink
