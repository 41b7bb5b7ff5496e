// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "crossing.h"

#include <optional>
#include <string>

namespace brink::bench {

/// One step that ten discrete checks say is free of contact, and brink's answer to it.
struct StripCase {
    Crossing crossing;
    std::size_t before = 0; // the last check before contact, of 0 to 10
    Toi toi;
};

/// The first of the seed's crossings of a spinning box and a wall, in one plane, that ten checks (FCL
/// collide) miss and that happens in the middle part of the step. Empty if there is none among a thousand.
std::optional<StripCase> strip_case(std::uint64_t seed);

/// In three frames side by side: the box where the checks see it, the wall between two of these poses, and
/// brink's pose of contact.
std::string strip_plot(const StripCase&);

} // namespace brink::bench
