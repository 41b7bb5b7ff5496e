// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene_figures.h"

#include <string>

namespace brink::bench {

/// One table for each scene and order: all sizes, brink and rivals with one thread.
std::string scene_tables(const SceneResults&);
/// With more threads, and how many times faster than with one.
std::string thread_table(const SceneResults&);
/// A step of brink and of the rivals, from 100,000 bodies on. Empty where there are none.
std::string summary_table(const SceneResults&);
/// How the time of a step grows with n from 1e4 on: the slope of the line of least squares through the
/// logarithms. Empty where there are not two sizes of a library.
std::string growth_table(const SceneResults&);
/// What a step costs where few bodies move against one where all do, and the first impact against all.
std::string skipping_table(const SceneResults&);
std::string layer_table(const SceneResults&);
/// Of each scene the largest.
std::string ledger_tables(const SceneResults&);

std::string scenes_csv(const SceneResults&);
std::string layers_csv(const SceneResults&);

/// A gnuplot script, figures included: ms of a step over n in each scene, log-log, to scenes.svg and .png.
std::string scenes_plot(const SceneResults&);

} // namespace brink::bench
