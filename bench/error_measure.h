// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "error_contender.h"
#include "error_point.h"

namespace brink::bench {

/// How long the time of each contender is taken: so many repetitions, those of all contenders in turn so that
/// all see the same machine, each for about so long.
struct Patience {
    int repetitions;
    double ns;
};

/// Answers, errors and times of every contender: of the repetitions' means per query the middle one, which a
/// burst of other work on the machine does not move.
ErrorPoints measure(const Questions&, const Contenders&, const Patience&);

} // namespace brink::bench
