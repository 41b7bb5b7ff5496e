// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector.h"

#include <algorithm>

/// Powers of two, by which lengths can be multiplied without rounding.
namespace brink {

static inline double largest_coordinate(V3 v)
{
    return std::max(std::fabs(v.x), std::max(std::fabs(v.y), std::fabs(v.z)));
}

/// The exponent e with 2^(e-1) <= x < 2^e; 0 for x = 0. x >= 0, finite.
static inline int exponent(double x)
{
    int e = 0;
    std::frexp(x, &e);
    return e;
}

/// Of the powers of two that lengths are divided by the least: its inverse is a normal number, too.
inline constexpr int least_exponent = -1000;

static inline V3 scaled(V3 v, int e)
{
    return e == 0 ? v : V3{std::ldexp(v.x, e), std::ldexp(v.y, e), std::ldexp(v.z, e)};
}

/// A vector of the same direction whose largest coordinate lies between 1/2 and 1; zero for zero.
static inline V3 mantissa(V3 v) { return scaled(v, -exponent(largest_coordinate(v))); }

} // namespace brink
