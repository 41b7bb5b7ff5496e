// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query.h"
#include "random.h"

namespace brink::support {

/// Two shapes of a closed-form pair that touch at the start in exact arithmetic: every coordinate a small
/// integer, every distance a whole number. They approach, part or slide.
Query exactly_touching(Random&, const Pair&);

} // namespace brink::support
