// SPDX-License-Identifier: BSD-3-Clause
#include "join.h"

#include "tolerance.h"

#include <algorithm>
#include <cmath>

namespace brink {

namespace plain {

#define JOIN_ATTR

using V = float;
constexpr int width = 1;

inline V load(const float* from) { return *from; }
inline void store(float* to, V v) { *to = v; }
inline void store_all(std::uint32_t* to, std::uint32_t x) { *to = x; }
template <class T> inline void store_some(T* to, const T* from, Mask) { *to = *from; }
inline void add_where(std::uint32_t* to, std::uint32_t bits, Mask where) { *to |= where != 0 ? bits : 0; }
inline V all_of(float x) { return x; }
inline Mask bits_of(bool b) { return b ? 1 : 0; }
inline bool And(bool a, bool b) { return a && b; }
inline bool Or(bool a, bool b) { return a || b; }
inline bool AndNot(bool a, bool b) { return !a && b; }
inline V Abs(V x) { return std::fabs(x); }
inline V Min(V a, V b) { return a < b ? a : b; }
inline V Max(V a, V b) { return a > b ? a : b; }
inline V Sqrt(V x) { return std::sqrt(x); }
inline V IfThenElse(bool which, V yes, V no) { return which ? yes : no; }

#include "join_tests-inl.h"

#include "join-inl.h"

#undef JOIN_ATTR

} // namespace plain

Join plain_join() { return &plain::join; }

#if !BRINK_HAVE_HIGHWAY
Join widest_join() { return plain_join(); }
#endif

} // namespace brink
