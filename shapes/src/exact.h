// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector.h"

#include <cmath>

/// Error-free transforms (Dekker 1971, Knuth 1969): a rounded result and its rounding error, which is itself
/// a double. Exact unless something leaves the normal range. They need -ffp-contract=off.
namespace brink {

/// The unevaluated sum hi + lo.
struct Pair {
    double hi = 0, lo = 0;
};

static inline Pair two_sum(double a, double b)
{
    const double sum = a + b;
    const double b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

static inline Pair two_difference(double a, double b) { return two_sum(a, -b); }

/// The same bits with and without fused multiply-add hardware, because the error term is exact either way.
static inline Pair two_product(double a, double b)
{
    const double product = a * b;
#ifdef __FMA__
    return {product, std::fma(a, b, -product)};
#else
    constexpr double splitter = 134217729; // 2^27 + 1
    const double a_big = splitter * a, b_big = splitter * b;
    const double a_hi = a_big - (a_big - a), b_hi = b_big - (b_big - b);
    const double a_lo = a - a_hi, b_lo = b - b_hi;
    return {product, ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
#endif
}

/// Arithmetic on unevaluated sums, to some 4 u^2 of the terms (T. Dekker 1971, without his last step: `lo`
/// may grow to a few roundings of `hi`).
static inline Pair operator+(Pair a, Pair b)
{
    const Pair s = two_sum(a.hi, b.hi);
    return {s.hi, s.lo + (a.lo + b.lo)};
}
static inline Pair operator-(Pair a) { return {-a.hi, -a.lo}; }
static inline Pair operator-(Pair a, Pair b) { return a + -b; }
static inline Pair operator*(Pair a, Pair b)
{
    const Pair p = two_product(a.hi, b.hi);
    return {p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi)};
}
static inline double rounded(Pair a) { return a.hi + a.lo; }
static inline Pair square_root(Pair a)
{
    const double root = std::sqrt(a.hi);
    if (!(root > 0)) return {};
    return {root, rounded(a - two_product(root, root)) / (root + root)};
}
static inline XYZ<Pair> pairs(V3 v) { return {{v.x}, {v.y}, {v.z}}; }

/// a b - c d within 2 ulp, however much of it cancels (W. Kahan 2004).
static inline double difference_of_products(double a, double b, double c, double d)
{
    const Pair p = two_product(a, b), q = two_product(c, d);
    return (p.hi - q.hi) + (p.lo - q.lo);
}

/// The cross product with every component within 2 ulp: that of nearly parallel vectors keeps its direction.
static inline V3 careful_cross(V3 a, V3 b)
{
    return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
            difference_of_products(a.x, b.y, a.y, b.x)};
}

} // namespace brink
