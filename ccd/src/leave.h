// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "course.h"

#include <optional>

namespace brink {

/// From a start not in contact but within the tolerance of it, or so near that rounding cannot tell, to where
/// the gap exceeds the tolerance: a hit unless it is proven not to decrease. An answer where that ends the
/// query; else the course stands at a time from which the way to the next contact begins.
template <class Part> std::optional<Toi> leave(Course<Part>&, const Separation& now);

/// The same from a start in contact, as the options' start_contact says.
template <class Part> std::optional<Toi> leave_contact(Course<Part>&, const Separation& now);

} // namespace brink
