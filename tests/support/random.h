// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/pose.h>

#include <cmath>
#include <cstdint>

namespace brink::support {

/// Seeded random numbers (splitmix64, S. Vigna 2015) with distributions of our own, not std's, which differ
/// between libraries. Draw into named variables: the order in which arguments are evaluated differs between
/// compilers.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    /// The stream of one case: a function of seed and index alone, unrelated to its neighbours'.
    Random(std::uint64_t seed, std::uint64_t index)
        : state_(Random(seed).bits() ^ (index * 0xd1342543de82ef95U))
    {
        state_ = bits();
    }

    std::uint64_t bits()
    {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31U);
    }

    /// In [lo, hi).
    double between(double lo, double hi) { return lo + (hi - lo) * fraction(); }

    /// In [lo, hi), both > 0: every binade as likely as another, uniform within it (no logarithm: its last
    /// bit differs between machines).
    double log_between(double lo, double hi)
    {
        const int first = std::ilogb(lo);
        const int binades = std::ilogb(hi) - first + 1;
        for (;;) {
            const int exponent = first + index(binades);
            const double value = std::ldexp(between(1, 2), exponent);
            if (value >= lo && value < hi) return value;
        }
    }

    /// In [0, n), n >= 1.
    int index(int n) { return static_cast<int>(fraction() * n); }

    bool chance(double p) { return fraction() < p; }

    /// In the cube of half edge h about the origin.
    Vec3 in_cube(double h)
    {
        const double x = between(-h, h);
        const double y = between(-h, h);
        const double z = between(-h, h);
        return {x, y, z};
    }

    /// Uniform on the unit sphere (by rejection: no transcendental function, so the same bits everywhere).
    Vec3 unit()
    {
        for (;;) {
            const Vec3 v = in_cube(1);
            const double n = v.x() * v.x() + v.y() * v.y() + v.z() * v.z();
            if (n > 1 || n < 1e-4) continue;
            const double length = std::sqrt(n);
            return {v.x() / length, v.y() / length, v.z() / length};
        }
    }

    /// Uniform over all rotations, unit within a few ulp.
    Quat rotation()
    {
        for (;;) {
            const double w = between(-1, 1);
            const Vec3 v = in_cube(1);
            const double n = w * w + (v.x() * v.x() + v.y() * v.y() + v.z() * v.z());
            if (n > 1 || n < 1e-4) continue;
            const double length = std::sqrt(n);
            return {w / length, v.x() / length, v.y() / length, v.z() / length};
        }
    }

private:
    /// In [0, 1), 53 bits.
    double fraction() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }

    std::uint64_t state_;
};

} // namespace brink::support
