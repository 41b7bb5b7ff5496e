// SPDX-License-Identifier: BSD-3-Clause
#include "hull_data.h"
#include "lanes.h"
#include "simplex.h"
#include "support.h"

#include <cstddef>

namespace brink {

namespace {

/// Up to so many corners looking at all of them is quicker than walking from one to the next.
constexpr int most_scanned = 64;

std::size_t at(int k) { return static_cast<std::size_t>(k); }

/// The highest corners so far, two side by side, and which those are.
struct Top {
    Two height = both(-infinity), corner{};

    void look(Two other, Two at)
    {
        corner = select(other > height, at, corner);
        height = larger(other, height);
    }
};

/// The highest of four places among four, each with its own best, so that nothing waits for the step before.
int highest(Top even, Top odd)
{
    const TwoFlags later = odd.height > even.height;
    const Two height = select(later, odd.height, even.height),
              corner = select(later, odd.corner, even.corner);
    // No branch here: nobody can predict it.
    return static_cast<int>(select(both(height[1]) > height, both(corner[1]), corner)[0]);
}

/// Of all corners.
int scan(const HullData& h, V3 d)
{
    const auto heights = [&](const HullData::Corners& four, std::size_t k) {
        return dot(XYZ<Two>{load_two(&four.x[k]), load_two(&four.y[k]), load_two(&four.z[k])}, both(d));
    };
    Top even, odd;
    Two corners{0, 1};
    for (const HullData::Corners& four : h.corners) {
        even.look(heights(four, 0), corners);
        odd.look(heights(four, 2), corners + both(2));
        corners = corners + both(4);
    }
    return highest(even, odd);
}

#ifdef __x86_64__
/// Three coordinates in a wide register, and zero.
[[gnu::target("avx2")]] inline __m256d load_three(const V3& v)
{
    return _mm256_maskload_pd(&v.x, __m256i{-1, -1, -1, 0});
}

/// A corner in a wide register, whose fourth lane is of no use, and which it is.
struct Wide {
    __m256d point;
    int corner;
};

/// The corner farthest along a direction, both in the hull's own frame, then placed; all in wide registers
/// with nothing called in between. The same as from farthest(), bit for bit.
[[gnu::target("avx2"), gnu::always_inline]] inline Wide scanned_by_four(const Core& c, V3 along)
{
    const HullData& h = *c.hull;
    const __m256d dx = _mm256_set1_pd(along.x), dy = _mm256_set1_pd(along.y), dz = _mm256_set1_pd(along.z);
    // Which corner it is goes together with where in memory it lies, which would take long to compute.
    constexpr auto id = [](long long bytes, long long corner) { return bytes << 32 | corner; };
    constexpr long long next = id(sizeof(double), 1), next_four = id(sizeof(HullData::Corners), 4);
    __m256d height = _mm256_set1_pd(-infinity), top = _mm256_setzero_pd();
    __m256i ids = _mm256_setr_epi64x(0, next, 2 * next, 3 * next);
    for (const HullData::Corners& four : h.corners) {
        const __m256d other =
            _mm256_load_pd(four.x) * dx + _mm256_load_pd(four.y) * dy + _mm256_load_pd(four.z) * dz;
        top = _mm256_blendv_pd(top, _mm256_castsi256_pd(ids), _mm256_cmp_pd(other, height, _CMP_GT_OQ));
        height = _mm256_max_pd(other, height);
        ids = _mm256_add_epi64(ids, _mm256_set1_epi64x(next_four));
    }
    const auto higher = [](__m128d a, __m128d b) { return _mm_cmpgt_pd(a, b); };
    const __m128d heights[2] = {_mm256_castpd256_pd128(height), _mm256_extractf128_pd(height, 1)};
    const __m128d later = higher(heights[1], heights[0]);
    const __m128d of_two = _mm_blendv_pd(heights[0], heights[1], later);
    const __m128d tops = _mm_blendv_pd(_mm256_castpd256_pd128(top), _mm256_extractf128_pd(top, 1), later);
    const __m128d best =
        _mm_blendv_pd(tops, _mm_unpackhi_pd(tops, tops), higher(_mm_unpackhi_pd(of_two, of_two), of_two));
    const long long found = _mm_cvtsi128_si64(_mm_castpd_si128(best));
    const auto* x =
        reinterpret_cast<const double*>(reinterpret_cast<const char*>(h.corners.data()) + (found >> 32));
    return {_mm256_broadcast_sd(x) * load_three(c.axes.x) +
                _mm256_broadcast_sd(x + 4) * load_three(c.axes.y) +
                _mm256_broadcast_sd(x + 8) * load_three(c.axes.z) + load_three(c.centre),
            static_cast<int>(found)};
}

[[gnu::target("avx2")]] SupportPoint farthest_by_four(const Core& c, const V3& d)
{
    const Wide found = scanned_by_four(c, into(c.axes, d));
    static_assert(sizeof(SupportPoint) == sizeof found.point && offsetof(SupportPoint, point) == 0);
    SupportPoint top;
    _mm256_storeu_pd(reinterpret_cast<double*>(&top), found.point); // the fourth falls on `corner`
    top.corner = found.corner;
    return top;
}

[[gnu::target("avx2")]] void put_by_four(Simplex::Corner& c, const Core& a, const Core& b, const V3& v)
{
    const Wide on_a = scanned_by_four(a, into(a.axes, v)), on_b = scanned_by_four(b, -into(b.axes, v));
    // The fourth falls on what is stored after it.
    static_assert(offsetof(Simplex::Corner, on_a) == sizeof(V3) &&
                  offsetof(Simplex::Corner, on_b) == 2 * sizeof(V3) &&
                  sizeof(Simplex::Corner) > 3 * sizeof(V3));
    _mm256_storeu_pd(&c.w.x, on_b.point - on_a.point);
    _mm256_storeu_pd(&c.on_a.x, on_a.point);
    _mm256_storeu_pd(&c.on_b.x, on_b.point);
    c.in_a = on_a.corner;
    c.in_b = on_b.corner;
    c.weight = 1;
}
#endif

/// The highest of every so-manieth corner.
int sample(const HullData& h, V3 d, int stride)
{
    int best = 0;
    double highest = dot(h.corner(0), d);
    for (int k = stride; k < h.count; k += stride) {
        const double height = dot(h.corner(k), d);
        if (height > highest) highest = height, best = k;
    }
    return best;
}

/// From corner to highest neighbour, to where none is higher: on a convex polyhedron that is the highest of
/// all. Heights are told apart by the edge between, whose rounding is relative to its own length. Should
/// rounding lead round in a circle, it is a scan after all.
int climb(const HullData& h, V3 d)
{
    int top = sample(h, d, h.count / most_scanned);
    for (int step = 0; step < h.count; ++step) {
        const V3 corner = h.corner(top);
        double highest = 0;
        int next = top;
        for (int i = h.first_neighbour[at(top)]; i < h.first_neighbour[at(top + 1)]; ++i) {
            const int k = h.neighbours[at(i)];
            const double height = dot(h.corner(k) - corner, d);
            if (height > highest) highest = height, next = k;
        }
        if (next == top) return top;
        top = next;
    }
    return scan(h, d);
}

} // namespace

HullData::Search quickest_search(const HullData& h)
{
    if (h.count > most_scanned && !h.neighbours.empty()) return HullData::Search::climb;
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2") != 0) return HullData::Search::wide_scan;
#endif
    return HullData::Search::scan;
}

int farthest(const HullData& h, V3 d)
{
    return h.search == HullData::Search::climb ? climb(h, d) : scan(h, d);
}

/// These two apart from what is usual, which then has nothing to save on its way in.
[[gnu::noinline]] static SupportPoint farthest_one_by_one(const Core& c, const V3& d)
{
    const int k = farthest(*c.hull, into(c.axes, d));
    return {corner(c, k), k};
}

SupportPoint farthest_of_hull(const Core& c, const V3& d)
{
#ifdef __x86_64__
    if (c.hull->search == HullData::Search::wide_scan) return farthest_by_four(c, d);
#endif
    return farthest_one_by_one(c, d);
}

[[gnu::noinline]] static void put_one_by_one(Simplex::Corner& c, const Core& a, const Core& b, const V3& v)
{
    const SupportPoint on_a = farthest_one_by_one(a, v), on_b = farthest_one_by_one(b, -v);
    c = {on_b.point - on_a.point, on_a.point, on_b.point, on_a.corner, on_b.corner, 1};
}

void put_corner_of_hulls(Simplex::Corner& c, const Core& a, const Core& b, const V3& v)
{
#ifdef __x86_64__
    const auto wide = [](const Core& core) { return core.hull->search == HullData::Search::wide_scan; };
    if (wide(a) && wide(b)) return put_by_four(c, a, b, v);
#endif
    put_one_by_one(c, a, b, v);
}

V3 face_towards(const Core& c, V3 d)
{
    const V3 along = into(c.axes, d);
    V3 best;
    double highest = -infinity;
    for (const HullData::Faces& two : c.hull->faces)
        for (std::size_t i = 0; i < 2; ++i) {
            const V3 n{two.x[i], two.y[i], two.z[i]};
            if (dot(n, along) > highest) highest = dot(n, along), best = n;
        }
    return c.axes * best;
}

double depth(const HullData& h, V3 point)
{
    Two least = both(h.faces.empty() ? 0 : infinity);
    for (const HullData::Faces& two : h.faces) {
        const XYZ<Two> n{load_two(two.x), load_two(two.y), load_two(two.z)};
        least = smaller(load_two(two.offset) - dot(n, both(point)), least);
    }
    return least[1] < least[0] ? least[1] : least[0];
}

} // namespace brink
