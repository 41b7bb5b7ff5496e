// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector.h"

#include <cstring>

#ifdef __SSE2__
#include <immintrin.h>
#endif

/// Two doubles side by side (a vector extension of g++ and clang; one SSE2 register), and the same words for
/// one. Each lane has the bits that the scalar operation has. Selects instead of branches: in these kernels
/// nobody can predict which way a branch goes.
namespace brink {

using Two = double __attribute__((vector_size(16)));
using TwoFlags = long long __attribute__((vector_size(16)));

static inline Two both(double value) { return Two{value, value}; }
static inline XYZ<Two> both(V3 v) { return {both(v.x), both(v.y), both(v.z)}; }
static inline XYZ<Two> pair(V3 a, V3 b) { return {Two{a.x, b.x}, Two{a.y, b.y}, Two{a.z, b.z}}; }
static inline V3 first(XYZ<Two> v) { return {v.x[0], v.y[0], v.z[0]}; }
static inline V3 second(XYZ<Two> v) { return {v.x[1], v.y[1], v.z[1]}; }

/// Two that lie side by side in memory.
static inline Two load_two(const double* p)
{
    Two v;
    std::memcpy(&v, p, sizeof v);
    return v;
}

static inline Two select(TwoFlags which, Two yes, Two no) { return which ? yes : no; }

static inline Two magnitude(Two v)
{
    return reinterpret_cast<Two>(reinterpret_cast<TwoFlags>(v) & ~reinterpret_cast<TwoFlags>(both(-0.0)));
}

/// v where `way` is positive, -v where it is negative.
static inline Two along(Two v, Two way)
{
    const TwoFlags sign = reinterpret_cast<TwoFlags>(way) & reinterpret_cast<TwoFlags>(both(-0.0));
    return reinterpret_cast<Two>(reinterpret_cast<TwoFlags>(v) ^ sign);
}
static inline Two against(Two v, Two way) { return along(-v, way); }

/// The first where it is larger or smaller, else the second; so the second where either is NaN.
static inline Two larger(Two a, Two b)
{
#ifdef __SSE2__
    return _mm_max_pd(a, b);
#else
    return select(a > b, a, b);
#endif
}
static inline Two smaller(Two a, Two b)
{
#ifdef __SSE2__
    return _mm_min_pd(a, b);
#else
    return select(a < b, a, b);
#endif
}

/// One bit for each lane.
static inline unsigned bits(TwoFlags flags)
{
#ifdef __SSE2__
    return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(flags)));
#else
    return (flags[0] != 0 ? 1U : 0U) | (flags[1] != 0 ? 2U : 0U);
#endif
}

static inline Two square_root(Two v)
{
#ifdef __SSE2__
    return _mm_sqrt_pd(v);
#else
    return Two{std::sqrt(v[0]), std::sqrt(v[1])};
#endif
}

static inline Two norm(XYZ<Two> v) { return square_root(norm_squared(v)); }

/// What a b differs from `product`, its rounding, by (Dekker 1971): the same bits with and without fused
/// multiply-add hardware, because it is exact either way.
static inline Two product_error(Two a, Two b, Two product)
{
#if defined(__FMA__) && defined(__SSE2__)
    return _mm_fmsub_pd(a, b, product);
#else
    const Two splitter = both(134217729); // 2^27 + 1
    const Two a_big = splitter * a, b_big = splitter * b;
    const Two a_hi = a_big - (a_big - a), b_hi = b_big - (b_big - b);
    const Two a_lo = a - a_hi, b_lo = b - b_hi;
    return ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo;
#endif
}

/// Two unevaluated sums hi + lo.
struct TwoPairs {
    Two hi, lo;
};
static inline TwoPairs two_sum(Two a, Two b)
{
    const Two sum = a + b, b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}
static inline TwoPairs two_product(Two a, Two b)
{
    const Two product = a * b;
    return {product, product_error(a, b, product)};
}

/// a b - c d within 2 ulp (W. Kahan 2004).
static inline Two difference_of_products(Two a, Two b, Two c, Two d)
{
    const Two p = a * b, q = c * d;
    return (p - q) + (product_error(a, b, p) - product_error(c, d, q));
}

/// The cross product with every component within 2 ulp: that of nearly parallel vectors keeps its direction.
static inline XYZ<Two> careful_cross(XYZ<Two> a, XYZ<Two> b)
{
    return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
            difference_of_products(a.x, b.y, a.y, b.x)};
}

} // namespace brink
