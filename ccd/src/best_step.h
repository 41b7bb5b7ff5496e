// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sight.h"

/// Which of the axes at hand proves the longest step.
namespace brink {

/// Whether their fastest possible approach takes longer than the horizon: most pairs of a step never come
/// near, and a first look shows it.
bool passes(const Facing<Core>&, const Sight&, double horizon);
bool passes(const Facing<Border>&, const Sight&, double horizon);

/// After a first look.
template <class Part> Step first_step(const Facing<Part>&, const Sight&, double horizon);

/// After a look, or from features followed since. `rolling` is the spin of the normal between curved
/// surfaces, as far as it is known.
template <class Part> Step best_step(const Facing<Part>&, const Sight&, V3 rolling, double horizon);

/// How features fare that are followed from a look on.
struct Trail {
    int followed = 0;           // axis steps since the look
    double seen_gap = infinity; // at that look, or where the features landed last
    double last_gap = infinity; // at the last step

    /// Whether they have lost what touches first; lands them in `sight` where that is worth it.
    bool lost(const Step&, const Facing<Core>&, Watch&, Sight&, double radii);
    /// Of a plane nothing can be lost.
    bool lost(const Step&, const Facing<Border>&, const BorderWatch&, const Sight&, double) const;
};

/// An axis that needs no look, and how long a step it proves.
struct AtHand {
    V3 normal;
    double length = 0;
};
/// The best of these: one that has served until here, where it was or gone along with either body, one that
/// has been followed, corner by corner, and the one from the midst of A to that of B.
template <class Part>
AtHand step_at_hand(const Facing<Part>&, const AtHand& served, const TurningAxis& followed, double horizon);

} // namespace brink
