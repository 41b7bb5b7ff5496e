// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query.h"

namespace brink::support {

/// How the first root of a t^2 + 2 b t + c is taken.
enum class Root : unsigned char {
    textbook, // (-b - sqrt(b^2 - a c)) / a
    stable,   // c / (-b + sqrt(b^2 - a c))
};

/// First contact of a pair that has a closed form, translation only, as the textbooks have it and in plain
/// double: the moving point against a ball about every corner, an infinite cylinder about every edge with the
/// foot between its ends, and every face moved outwards (Ericson, Real-Time Collision Detection, 2005,
/// chapter 5). 0 when in contact at the start, empty when there is none in [0, t_max]. What brink is compared
/// with.
std::optional<double> textbook_toi(const Query&, Root);

} // namespace brink::support
