// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace brink::bench {

/// What the figures were measured on and with: processor, compiler and flags, versions. Two lines.
std::string machine();

/// Where a folder of results says what it was measured on.
inline constexpr std::string_view machine_file = "machine.txt";

/// Which build of the library this program was linked with: "baseline" or "x86-64-v3".
std::string build_name();

/// Whether this processor runs the x86-64-v3 build.
bool runs_v3();

} // namespace brink::bench
