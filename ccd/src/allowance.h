// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tolerance.h"

#include <brink/toi.h>

#include <algorithm>

namespace brink {

/// What rounding may do to the gaps of a query, and how near counts as there (numerics.md section 3).
struct Allowance {
    double rounding = 0;  // of a gap, at most
    double slack = 0;     // what it can take off a bound
    double tolerance = 0; // the caller's, less what the gap there may be off by; at least twice the slack

    Allowance() = default;
    /// `lengths` are those that roundings are relative to, added up.
    Allowance(double lengths, const Options& options)
        : rounding(tolerance::certificate_slack * lengths),
          tolerance(std::max(options.tolerance - tolerance::least_slack * lengths,
                             2 * tolerance::least_slack * lengths))
    {
        slack = std::min(rounding, 0.5 * tolerance);
    }
};

} // namespace brink
