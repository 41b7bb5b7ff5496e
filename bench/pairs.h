// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output.h"

#include <filesystem>
#include <string>
#include <vector>

namespace brink::bench {

/// ns per query of the pairs named (pair_names), of this build and of the x86-64-v3 build of the library
/// (asked from `sibling`, the same program over that build, if there is one that runs here), with FCL's
/// conservative advancement beside them. Tables on stdout, pairs.csv and the picture to `output`.
void run_pairs(const Output& output, const std::vector<std::string>& names,
               const std::filesystem::path& sibling);

} // namespace brink::bench
