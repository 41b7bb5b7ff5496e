// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "crossing.h"

#include <fcl.h>

#include <array>
#include <optional>
#include <string_view>

namespace brink::bench {

/// A crossing with FCL's geometries prepared, so that preparing them is nobody's time.
struct Question {
    explicit Question(const Crossing& c) : crossing(c), fcl_a(c.a), fcl_b(c.b) {}

    Crossing crossing;
    support::FclBody fcl_a, fcl_b;
};

/// One way to look for a contact within a step. `ask` answers when it saw one, empty when it saw none.
struct Method {
    std::string_view name;  // in the CSV
    std::string_view title; // in table and picture
    std::optional<double> (*ask)(const Question&);
};

/// Discrete checks (FCL collide) at the end of 1, 10 and 100 equal parts of the step, FCL's continuousCollide
/// at its defaults and by conservative advancement, and brink.
extern const std::array<Method, 6> methods;

} // namespace brink::bench
