// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace brink::bench {

/// Compares two folders of CSVs: brink's time over its rivals' in the same run (so that the machine does not
/// count), with the spread, and its errors and wrong answers. Prints a table and what got slower or less
/// exact by more than the noise; gives how many such things there are. Throws std::invalid_argument, naming
/// the folder, where one holds nothing to compare.
int compare(const std::filesystem::path& before, const std::filesystem::path& after);

} // namespace brink::bench
