// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>

namespace brink {

/// What may settle a pair of bodies before it is asked exactly, from the cheapest to the dearest.
enum class Layer : unsigned char {
    immovable, // neither can move
    asleep,    // neither can move for now
    bounds,    // their swept bounds, or the swept segment of one and those of the other, are apart
    receding,  // the balls around them are apart and do not near each other
    spheres,   // the balls around them pass each other
    late,      // the balls around them meet later than what is already known or asked for
    mask,      // category and mask; where whole blocks of bodies exclude each other, told as bounds
    filter,    // the user's
    simd,      // settles no pair: sixteen bodies at once, with the widest instructions there are
};
inline constexpr int layer_count = 8; // that settle pairs

/// A set of layers.
struct Layers {
    std::uint32_t bits = 0;
    constexpr Layers() = default;
    constexpr Layers(Layer l) : bits(1U << static_cast<unsigned>(l)) {}
    constexpr bool has(Layer l) const { return (bits >> static_cast<unsigned>(l) & 1U) != 0; }
    friend constexpr Layers operator|(Layers x, Layers y)
    {
        x.bits |= y.bits;
        return x;
    }
};
constexpr Layers operator|(Layer x, Layer y) { return Layers(x) | Layers(y); }

/// What one query of a scene did: which layer settled how many pairs, and how long the stages took.
struct Ledger {
    std::uint64_t pairs = 0;                          // n (n - 1) / 2 of n bodies, or n for a cast
    std::array<std::uint64_t, layer_count> removed{}; // by Layer
    std::uint64_t exact = 0;                          // asked exactly
    std::uint64_t left = 0;                           // not looked at: stopped, or beyond max_tests
    std::uint64_t again = 0; // once more (safe_times): a partner halted, or many others come first
    double update_seconds = 0, search_seconds = 0, exact_seconds = 0, order_seconds = 0;

    std::uint64_t by(Layer l) const { return removed[static_cast<unsigned>(l)]; }
};

/// A table, one line for each layer and each stage.
std::ostream& operator<<(std::ostream&, const Ledger&);

} // namespace brink
