// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output.h"

#include <string>

namespace brink::bench {

struct ReplayOptions {
    std::string file; // queries as text
};

/// Where the recorded workload lies in the checkout that this program was built from.
std::string recorded_workload();

/// Asks every query of the file of brink, and of FCL what it supports; prints tables, writes replay.csv and
/// replay.svg/png. Returns how many objections the referee has against brink: promises broken, and
/// `undecided` where nothing grazes (0 where the build has no referee). Throws std::runtime_error where the
/// file cannot be read.
std::size_t run_replay(const Output&, const ReplayOptions&);

} // namespace brink::bench
