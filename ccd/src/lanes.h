// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector.h"

#ifdef __SSE2__
#include <emmintrin.h>
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

static inline Two select(TwoFlags which, Two yes, Two no) { return which ? yes : no; }

static inline Two square_root(Two v)
{
#ifdef __SSE2__
    return _mm_sqrt_pd(v);
#else
    return Two{std::sqrt(v[0]), std::sqrt(v[1])};
#endif
}

} // namespace brink
