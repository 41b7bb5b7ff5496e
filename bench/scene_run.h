// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene_figures.h"

#include <functional>
#include <scenes.h>

namespace brink::bench {

/// One scene to measure.
struct SceneTask {
    std::string scene, order;
    std::size_t n = 0;
    std::vector<int> threads;
    int steps = 0;
};

/// Draws the scene, measures brink with each number of threads and the rivals beside it, and adds figures and
/// ledgers to what there is.
SceneResults measure_scene(const SceneTask&, SceneResults so_far);

/// A scene in which each layer is switched off in turn.
std::vector<LayerFigures> measure_layers(std::string_view scene, std::size_t n);

/// In seconds.
double time_of(const std::function<void()>& work);

double median(std::vector<double>);

} // namespace brink::bench
