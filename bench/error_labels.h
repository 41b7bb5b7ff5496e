// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace brink::bench {

/// A mark in a panel, in pixels from the panel's lower left corner, and what is to be written beside it:
/// often nothing.
struct Spot {
    double x = 0, y = 0;
    std::string text;
};

/// The panel, and the size of a letter in it, in pixels.
struct Canvas {
    double width, height;
    double letter_width, letter_height;
};

/// Where the middle of each spot's text goes, so that texts stay clear of marks and of one another as far as
/// there is room near their own.
std::vector<Spot> placed_labels(const std::vector<Spot>&, const Canvas&);

} // namespace brink::bench
