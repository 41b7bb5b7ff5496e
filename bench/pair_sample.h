// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/ccd.h>
#include <random.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brink::bench {

struct Body {
    Shape shape;
    Motion motion;
};

/// Indices into `Sample::bodies`.
struct Pair {
    std::uint16_t a, b;
};

/// 2,048 bodies, which stay in cache, and some 100,000 distinct pairs of them in random order, which no
/// branch predictor learns. The bodies measure 0.2 to 2 m, the pairs begin 0.2 to 5 m apart.
struct Sample {
    std::vector<Body> bodies;       // the first half are A's, the second B's
    std::vector<Pair> hits, misses; // hits: undecided ones among them
    std::vector<Pair> mixed;        // half of either
};

using DrawShape = Shape (*)(support::Random&);

/// Draws shapes of that index in the Shape variant.
DrawShape draw_of(std::size_t shape);

/// A pair of shapes to measure, by the functions that draw them.
struct PairKind {
    std::string_view name;
    DrawShape draw_a, draw_b;
};

/// How either body turns over the step, about its middle and an axis at random: not at all, or by an angle
/// from nothing to 60, or to 300, degrees.
enum class Turning : unsigned char { none, to_60_degrees, to_300_degrees };
inline constexpr std::array every_turning{Turning::none, Turning::to_60_degrees, Turning::to_300_degrees};
/// "none", "60" or "300".
std::string_view name_of(Turning);

/// The pairs that are measured so.
std::span<const PairKind> pairs_turning(Turning);
/// The names of all of them, each once.
std::vector<std::string> pair_names();

/// `pairs` hits, as many misses, and a mix. Throws std::logic_error where the bodies do not give that many.
Sample draw_sample(const PairKind&, Turning, std::size_t pairs);

} // namespace brink::bench
