// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/ccd.h>
#include <random.h>

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

/// 2,048 bodies, which stay in cache, and 262,144 distinct pairs of them in random order, which no branch
/// predictor learns. The bodies measure 0.2 to 2 m, the pairs begin 0.2 to 5 m apart.
struct Sample {
    std::vector<Body> bodies; // the first half are A's, the second B's
    std::vector<Pair> hits, misses;
    std::vector<Pair> mixed; // half of either
};

/// A pair of shapes to measure, by the functions that draw them.
struct PairKind {
    std::string_view name;
    Shape (*draw_a)(support::Random&);
    Shape (*draw_b)(support::Random&);
};

/// Every pair that a closed form decides when nothing rotates.
std::span<const PairKind> closed_pairs();
/// Pairs that go to advancement where something rotates.
std::span<const PairKind> rotating_pairs();
/// The names of both, each once.
std::vector<std::string> pair_names();

enum class Turning : unsigned char { none, to_60_degrees };

/// `pairs` hits, as many misses, and a mix. Throws std::logic_error where the bodies do not give that many.
Sample draw_sample(const PairKind&, Turning, std::size_t pairs);

} // namespace brink::bench
