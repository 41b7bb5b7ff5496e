// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "stability_case.h"

namespace brink::bench {

/// brink's answers, and FCL's where it can be asked, to a block's cases of support::turning_classes, held
/// against the referee of 100 digits. Without a referee: nothing.
Scores measure_turning(const Block&, support::FclProcess&);

} // namespace brink::bench
