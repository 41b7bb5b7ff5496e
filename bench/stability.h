// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output.h"

#include <cstdint>
#include <string>
#include <vector>

namespace brink::bench {

struct StabilityOptions {
    std::uint64_t cases = 0; // of each pair and class; 0: 20,000 of two spheres, 2,000 of the others
    std::vector<std::string> pairs{"all"};
    std::vector<std::string> classes{"all"};
    std::uint64_t seed = 20261122;
    std::uint64_t first = 0; // index of the first case, so that a campaign can run in parts
    int threads = 0;         // 0: as many as the machine has
};

/// Names of the pairs that a closed form decides, and of the classes of difficulty.
std::vector<std::string> stability_pairs();
std::vector<std::string> stability_classes();

/// Error of t and wrong decisions of brink, the textbook's formulas and FCL, pair by pair and class by class,
/// against the referee of 200 digits. Tables on stdout, stability.csv and the picture to `output`.
/// Gives the number of brink's answers that break a promise, after printing the first of them as C++. Throws
/// std::runtime_error in a build without the referee.
std::uint64_t run_stability(const Output& output, const StabilityOptions& options);

} // namespace brink::bench
