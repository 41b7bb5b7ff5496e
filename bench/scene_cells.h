// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene_figures.h"

/// What the tables of scenes are made of.
namespace brink::bench {

/// 1234567 as "1,234,567".
std::string count(std::size_t n);

/// Three digits that count; "-" where nothing was measured.
std::string ms(double value);

/// How many times longer theirs is.
std::string times(double theirs, double ours);

/// Of a step; 0 of nobody.
double step_of(const SceneFigures*);

/// What names a table.
struct Heading {
    std::string scene, order;
    friend bool operator==(const Heading&, const Heading&) = default;
};

/// In the order measured.
std::vector<Heading> headings(const SceneResults&);

} // namespace brink::bench
