// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace brink {

/// How a query ended.
enum class Status : unsigned char {
    invalid,   // an input was not finite or out of range
    separated, // proven apart
    touching,  // in contact at the pose, or at the time, that the query began with
    hit,       // first contact found
    undecided, // budget spent: proven apart before t, nothing known after it
};

} // namespace brink
