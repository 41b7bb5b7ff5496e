// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "stability_score.h"

#include <string>

namespace brink::bench {

/// A gnuplot script, figures included: a panel for each class, a strip for each solver, over the level the
/// worst error of all pairs as a colour, wrong decisions as crosses.
std::string stability_plot(const Scores&);

} // namespace brink::bench
