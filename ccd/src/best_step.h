// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sight.h"

/// Which of the axes at hand proves the longest step.
namespace brink {

/// After a first look: most pairs of a step never come near, and their fastest approach shows it.
template <class Part> Step first_step(const Facing<Part>&, const Sight&, double horizon);

/// After a look, or from features followed since. `rolling` is the spin of the normal between curved
/// surfaces, as far as it is known.
template <class Part> Step best_step(const Facing<Part>&, const Sight&, V3 rolling, double horizon);

/// The length of a step proven without a look, by an axis that served before or that leads from the midst of
/// one body to that of the other.
template <class Part> double step_at_hand(const Facing<Part>&, V3 normal, double horizon);

} // namespace brink
