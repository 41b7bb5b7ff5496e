// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "error_point.h"

namespace brink::bench {

/// How a rival's mark lies to brink's curve.
enum class Place : unsigned char {
    beaten,  // brink is at least as exact in less time
    better,  // faster and more exact than brink: below and left of the curve
    cruder,  // faster, and less exact than brink at any of its tolerances
};

struct Mark {
    ErrorPoint rival;
    double factor = 0; // its time over brink's at the same error
    Place place = Place::beaten;
};

/// The marks of one question, those with the least factor first. A rival counts with its median error over the
/// hits it saw, whatever it missed. Errors below 2^-53, which t cannot tell apart, count as that. brink's time
/// at an error is the least of those of its tolerances that are no less exact, and of the lines between
/// neighbouring ones in the picture. At an error below all of brink's it is the time of its most exact one.
std::vector<Mark> marks(const ErrorPoints& of_one_question);

/// Of every question the nearest rival, and every mark that is not beaten; then what comes of it.
std::string error_verdict(const ErrorPoints&);

} // namespace brink::bench
