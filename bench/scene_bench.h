// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output.h"

#include <string>
#include <vector>

namespace brink::bench {

struct SceneBenchOptions {
    std::vector<std::string> scenes{"all"};
    std::vector<std::string> orders{"random", "spatial"};
    std::vector<std::size_t> n{1'000, 10'000, 100'000, 1'000'000};
    std::vector<int> threads{1, 2};
    int steps = 7;                 // that medians are of; fewer of what takes long
    std::size_t layers_n = 10'000; // bodies of the scenes whose layers are switched off; 0: none
};

/// Names of the scenes.
std::vector<std::string> bench_scenes();

/// ms to build, to update, to find pairs and impacts of whole scenes of moving bodies, the broad phases of
/// FCL and Bullet beside it over the same swept boxes; what each layer saves. Tables on stdout, scenes.csv,
/// scene_layers.csv and the picture to `output`. Gives how many times a rival found other pairs.
int run_scenes(const Output& output, const SceneBenchOptions& options);

} // namespace brink::bench
