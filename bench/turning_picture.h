// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "stability_score.h"

#include <string>

namespace brink::bench {

/// A gnuplot script, figures included: a panel for each class, over the level what of the allowance of design
/// promise 3 the answers use up.
std::string turning_plot(const Scores&);

} // namespace brink::bench
