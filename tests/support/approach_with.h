// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query.h"

namespace brink::support {

/// What takes a pair of bounded bodies to contact; each has all that those before it have.
enum class Ingredient : unsigned char {
    length_bound,  // gap over the fastest motion of any point
    directional,   // gap over the fastest approach along its normal
    second_order,  // a certificate for that normal, at rest
    features_axis, // one for the axis that the nearest features ask for, which turns with them
    following      // features followed between evaluations: the library's way
};

enum class Ending : unsigned char {
    hit,
    apart,  // said to stay apart
    stuck,  // no step proven
    capped, // out of evaluations
};

struct Way {
    Ending ending = Ending::capped;
    double t = 0;        // where it ended
    int evaluations = 0; // of the distance
    int steps = 0;
};

inline constexpr int most_evaluations = 20'000;

/// Goes to first contact by certified advancement with these ingredients. The query is valid, its lengths
/// are of usual scale and it begins apart; implemented in tests/approach_with.cpp, which asks the library's
/// own parts.
Way approach_with(Ingredient, const Query&);

} // namespace brink::support
