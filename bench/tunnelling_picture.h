// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tunnelling_report.h"

namespace brink::bench {

/// The gnuplot script that draws tunnelling.csv: a panel of the share missed for each scene, and one of the
/// cost per step.
std::string tunnelling_plot(const std::vector<Row>&);

} // namespace brink::bench
