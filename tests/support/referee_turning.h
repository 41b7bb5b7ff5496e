// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "referee_walk.h"
#include "verdict.h"

/// The referee of every pair, turning or not: first contact in 100 digits by a walk that cannot pass a root.
/// Its steps are proven in long double where that is enough (the gap and its bounds are then good for 1e-16
/// of the scale) and in 100 digits where it is not. Shares no code with brink or with the reference.
namespace brink::support {

/// What is so about a query that is judgeable(). Lengths in the scene's unit, times in steps.
struct Meeting {
    bool started = false;  // gap(0) <= target_gap
    bool meets = false;    // there is a contact in question in [0, t_max], begun by `by` at the latest
    bool in_doubt = false; // decided by less than 1e-40 of the scale, or the walk ran out of evaluations
    bool spent = false;    // the latter
    Hundred apart = 0;     // before this time there is no contact in question
    Hundred by = -1;       // there is one by this time; -1 where there is none. by - apart is next to nothing
    Hundred start_gap = 0; // minus target_gap, from above; so is the next
    Hundred least_gap = 0; // the least that the walk saw
    Hundred closing_speed = 0;                 // at contact, length per step
    bool grazing = false;                      // closing speed below 1e-3 of the fastest relative motion
    bool left = false;                         // started, and the gap has exceeded the target later, ...
    Hundred left_by = 0;                       // ... by this time: contact before it is not in question
    double drop = 0;                           // how far the gap fell before that, where the depth is known
    int evaluations = 0, fine_evaluations = 0; // of the gap, in long double and in 100 digits
};

/// Evaluations of the gap after which a walk runs out, in long double and in 100 digits.
struct Budget {
    int coarse = 40'000, fine = 600;
};

/// Valid, and at most one of the shapes is unbounded. (What is invalid is left to the tests of validity.)
bool judgeable(const Query&);

/// First contact. With contact at the start that the options say to ignore: the first after the gap has
/// exceeded the target (seen at no less than 1e-5 of the step from one look to the next: a shorter excursion
/// may be passed over, which errs in the answer's favour).
Meeting meeting(const Query&);

/// Which promises (design section 3) the answer breaks, gap, normal and points among them. Empty when it
/// keeps them all, or where the walk ran out of evaluations.
struct Ruling {
    Findings findings;
    bool unsettled = false; // the walk ran out of evaluations: `late` and `missed` are not excluded
    bool in_digits = false; // long double was not enough
};
Ruling rule(const Query&, const Toi&, const Budget& = {});

/// Whether an `undecided` at t is excused because something grazes: at t, or at contact, the pair closes at
/// less than 1e-3 of the fastest relative motion, or there is no contact by less than 1e-6 of the scale.
bool grazes(const Query&, const Meeting&, double t);

} // namespace brink::support
