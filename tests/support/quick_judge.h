// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query.h"

/// The judge of every case of a campaign: microseconds, in doubles, with bounds of its own rounding. It only
/// acquits; what it cannot acquit goes to the referee, who alone accuses. Shares no code with brink.
namespace brink::support {

enum class Acquittal : unsigned char {
    none,        // not proven: for the referee
    to_rounding, // no promise is broken by more than 16 eps S (promise 3) ...
    strict,      // ... and no contact before t, nor one that is missed, by anything at all
};

/// Why there was none, for the tally: what was tried first and failed.
enum class Doubt : unsigned char { nothing, form, start, apart, tight, upper, contact };

struct Quick {
    Acquittal acquittal = Acquittal::none;
    Doubt doubt = Doubt::nothing;
    int looks = 0; // evaluations of the gap, those at the ends of the time included
};

/// Promises 1, 2, 3 and 5, and gap, normal and points, of a query that is judgeable() (referee_turning.h).
/// Contact at the start that is ignored is not judged here, nor how deep cores overlap.
Quick quick_judge(const Query&, const Toi&);

} // namespace brink::support
