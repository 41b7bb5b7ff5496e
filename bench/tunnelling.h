// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output.h"

#include <cstdint>

namespace brink::bench {

struct TunnellingOptions {
    int crossings =
        34'000; // true crossings in each scene, over all speeds; rounded up to the same number at each
    std::uint64_t seed = 20261122;
};

/// Sweeps speed over wall thickness for every scene and method: the share of true crossings missed, late
/// answers, and time per query. Table on stdout, tunnelling.csv and the picture to `output`.
/// Gives the number of crossings that brink missed.
int run_tunnelling(const Output& output, const TunnellingOptions& options);

} // namespace brink::bench
