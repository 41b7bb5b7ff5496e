// SPDX-License-Identifier: BSD-3-Clause
// The join for every instruction set that Highway knows on this kind of machine, and the choice between them.
#if BRINK_HAVE_HIGHWAY

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "join_wide.cpp"
#include <hwy/foreach_target.h>
// After it, because it includes this file once more for each target.
#include <hwy/highway.h>

#include "join.h"
#include "tolerance.h"

#include <algorithm>

#define JOIN_ATTR HWY_ATTR

HWY_BEFORE_NAMESPACE();
namespace brink::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, lanes>;
using V = hn::Vec<D>;
constexpr D tag;
constexpr int width = static_cast<int>(hn::MaxLanes(tag));

using hn::Abs;
using hn::And;
using hn::AndNot;
using hn::IfThenElse;
using hn::Max;
using hn::Min;
using hn::Or;
using hn::Sqrt;

HWY_ATTR inline V load(const float* from) { return hn::Load(tag, from); }
HWY_ATTR inline void store(float* to, V v) { hn::Store(v, tag, to); }
constexpr hn::CappedTag<std::uint32_t, lanes> whole_tag;
HWY_ATTR inline void store_all(std::uint32_t* to, std::uint32_t x)
{
    hn::StoreU(hn::Set(whole_tag, x), whole_tag, to);
}
/// Those of the lanes that are in the set, one after the other; what lies behind them is overwritten too. (A
/// compress into memory takes Zen 4 ten times as long as one into a register.)
HWY_ATTR inline void store_some(std::uint32_t* to, const std::uint32_t* from, Mask which)
{
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(which), static_cast<std::uint8_t>(which >> 8U)};
    hn::StoreU(hn::Compress(hn::LoadU(whole_tag, from), hn::LoadMaskBits(whole_tag, bytes)), whole_tag, to);
}
HWY_ATTR inline void store_some(float* to, const float* from, Mask which)
{
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(which), static_cast<std::uint8_t>(which >> 8U)};
    hn::StoreU(hn::Compress(hn::LoadU(tag, from), hn::LoadMaskBits(tag, bytes)), tag, to);
}
/// Where the set says so: to |= bits.
HWY_ATTR inline void add_where(std::uint32_t* to, std::uint32_t bits, Mask where)
{
    constexpr hn::RebindToUnsigned<D> words;
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(where), static_cast<std::uint8_t>(where >> 8U)};
    const auto added = hn::IfThenElseZero(hn::LoadMaskBits(words, bytes), hn::Set(words, bits));
    hn::Store(hn::Or(hn::Load(words, to), added), words, to);
}
HWY_ATTR inline V all_of(float x) { return hn::Set(tag, x); }
HWY_ATTR inline Mask bits_of(hn::Mask<D> m)
{
    std::uint8_t bytes[8] = {}; // what StoreMaskBits may touch
    hn::StoreMaskBits(tag, m, bytes);
    return static_cast<Mask>(bytes[0]) | static_cast<Mask>(bytes[1]) << 8U;
}

#include "join_tests-inl.h"

#include "join-inl.h"

} // namespace brink::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brink {

HWY_EXPORT(join);

std::uint32_t join_by_target(const Packet& p, const BlockTree& tree, std::uint32_t own, std::uint32_t first,
                             const JoinRules& rules, Candidates& to, JoinCounts& counts)
{
    return HWY_DYNAMIC_DISPATCH(join)(p, tree, own, first, rules, to, counts);
}

Join widest_join() { return &join_by_target; }

} // namespace brink
#endif

#endif
