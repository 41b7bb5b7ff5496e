// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "summary.h"

#include <string>

namespace brink::bench {

/// One page that needs no other file: what was measured and on what, the summary, every part's pictures as
/// they are in the folder and all its figures. Every number is one of the CSVs'.
std::string report_page(const std::filesystem::path& folder, const std::vector<Found>&);

} // namespace brink::bench
