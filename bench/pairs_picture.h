// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pair_sample.h"
#include "timing.h"

#include <string>
#include <string_view>
#include <vector>

namespace brink::bench {

/// A gnuplot script, figures included, that draws the means of mixed queries as bars to <stem>.svg and .png.
/// Empty where no pair that turns so was measured.
std::string pairs_plot(const std::vector<Timing>&, Turning, std::string_view stem);

} // namespace brink::bench
