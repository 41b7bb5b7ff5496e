// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "course.h"

#include <optional>

namespace brink {

/// From a start in contact, or within the tolerance of it, to where the gap exceeds the tolerance, as the
/// options' start_contact says. An answer where that ends the query; else the course stands at a time from
/// which the way to the next contact begins.
template <class Part> std::optional<Toi> leave(Course<Part>&, const Separation& now);

/// The answer for a start proven in contact, where that ends the query.
template <class Part> std::optional<Toi> leave_contact(Course<Part>&, const Separation& now);

} // namespace brink
