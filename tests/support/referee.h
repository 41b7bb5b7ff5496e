// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "digits.h"
#include "verdict.h"

/// Every closed_form() pair under translation once more, feature by feature in 200 digits: who is right where
/// doubles (or the long double reference) cannot tell. Shares no code with brink or with the reference.
namespace brink::support {

/// What is so about a query that `refereed`. Lengths in the scene's unit, times in steps.
struct Truth {
    bool started = false;  // gap(0) <= target_gap
    bool meets = false;    // gap(t) <= target_gap for some t in [0, t_max]
    bool in_doubt = false; // a decision came within 1e-90 of the scale, with rounding: either answer is right
    Digits t = -1;         // first contact in [0, infinity) when there is one (0 when started); else -1
    Digits blur = 0;       // how far t may be off by rounding; 0 where it was computed without
    Digits least_gap = 0;  // over [0, t_max], minus target_gap; from below only as deep as the cores touching
    Digits closing_speed = 0; // at t, length per step; 0 when started or when there is no contact
    Digits scale = 0;         // S of design promise 3
};

/// Whether truth() can judge it: a closed-form pair in either order, valid, and translation only (a sphere
/// may turn about its centre).
bool refereed(const Query&);

/// The query must be `refereed`, here and below.
Truth truth(const Query&);

/// gap(t) - target_gap, signed; t may lie outside the step.
Digits gap_minus_target(const Query&, const Digits& t);

/// Which promises (design section 3) the answer breaks; empty when it keeps them all. Contact at the start
/// that the options say to ignore: the gap of a translation is convex, so there is no second contact; under
/// `ignore` only `separated` is right, under `ignore_if_separating` `touching` always is and `separated`
/// where the gap does not fall.
Findings verify(const Query&, const Toi&);

/// |t - exact| in units of the last place of the double nearest to exact.
double ulp_error(const Digits& exact, double t);

} // namespace brink::support
