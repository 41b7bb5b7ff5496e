// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "course.h"
#include "sight.h"

namespace brink {

/// A place of contact ahead that was guessed, and what is proven about the way there.
struct Leap {
    double from = infinity, at = infinity; // times between which the bodies are proven apart; none so far
    Sight sight;                           // at the latter, within the tolerance of contact
};

/// Guesses when two bodies meet from how fast they near each other where they are, goes there, guesses again,
/// and at last proves the way there backwards: near contact one axis proves far more of the time before than
/// of the time to come. Leaves the course where it leads if all of the way is proven, else where it was. Not
/// between curved surfaces, where a look from a place too far on takes long. Whether there is a leap: else
/// the times stay what they were.
template <class Part, class WatchOfPart> bool leap(Course<Part>&, WatchOfPart&, const Sight& seen, Leap&);

} // namespace brink
