// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "error_point.h"

namespace brink::bench {

/// How a rival's mark lies to brink's curve.
enum class Place : unsigned char {
    above,  // brink is no less exact in less time
    within, // faster and more exact than brink at some tolerance: below and left of the curve
    right,  // faster, and less exact than brink at any tolerance
    left,   // slower, and more exact than brink at any tolerance
};

struct Mark {
    ErrorPoint rival;
    Place place = Place::above;
    double factor = 0; // its time over brink's at the same error
};

/// The marks of one question, those with the least factor first. A rival counts with its median error over
/// the hits it saw, whatever it missed. Errors below 2^-53, which t cannot tell apart, count as that. brink's
/// time at an error is the least of those of its tolerances that are no less exact, and of the lines between
/// neighbouring ones in the picture; at an error below all of brink's the time of its most exact tolerance.
std::vector<Mark> marks(const ErrorPoints& of_one_question);

/// Of every question the nearest rival, and every mark that is not `above`.
std::string error_verdict(const ErrorPoints&);

} // namespace brink::bench
