// SPDX-License-Identifier: BSD-3-Clause
#include "hull_data.h"
#include "lanes.h"
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

/// All of farthest() in wide registers, with nothing called in between: the same, bit for bit.
[[gnu::target("avx2")]] SupportPoint scanned_by_four(const Core& c, const V3& d)
{
    const HullData& h = *c.hull;
    const V3 along = into(c.axes, d);
    const __m256d dx = _mm256_set1_pd(along.x), dy = _mm256_set1_pd(along.y), dz = _mm256_set1_pd(along.z);
    __m256d height = _mm256_set1_pd(-infinity), corner{}, corners{0, 1, 2, 3};
    for (const HullData::Corners& four : h.corners) {
        const __m256d other =
            _mm256_loadu_pd(four.x) * dx + _mm256_loadu_pd(four.y) * dy + _mm256_loadu_pd(four.z) * dz;
        corner = _mm256_blendv_pd(corner, corners, _mm256_cmp_pd(other, height, _CMP_GT_OQ));
        height = _mm256_max_pd(other, height);
        corners += 4;
    }
    const int k = highest({_mm256_castpd256_pd128(height), _mm256_castpd256_pd128(corner)},
                          {_mm256_extractf128_pd(height, 1), _mm256_extractf128_pd(corner, 1)});
    const HullData::Corners& four = h.corners[at(k / 4)];
    const __m256d point = _mm256_set1_pd(four.x[k % 4]) * load_three(c.axes.x) +
                          _mm256_set1_pd(four.y[k % 4]) * load_three(c.axes.y) +
                          _mm256_set1_pd(four.z[k % 4]) * load_three(c.axes.z) + load_three(c.centre);
    static_assert(sizeof(SupportPoint) == sizeof point && offsetof(SupportPoint, point) == 0);
    SupportPoint top;
    _mm256_storeu_pd(reinterpret_cast<double*>(&top), point); // the fourth falls on `corner`
    top.corner = k;
    return top;
}
#endif

bool is_scanned(const HullData& h) { return h.count <= most_scanned || h.neighbours.empty(); }

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

int farthest(const HullData& h, V3 d) { return is_scanned(h) ? scan(h, d) : climb(h, d); }

/// Apart from what is usual, which then has nothing to save on its way in.
[[gnu::noinline]] static SupportPoint farthest_one_by_one(const Core& c, const V3& d)
{
    const int k = farthest(*c.hull, into(c.axes, d));
    return {corner(c, k), k};
}

SupportPoint farthest_of_hull(const Core& c, const V3& d)
{
#ifdef __x86_64__
    if (is_scanned(*c.hull) && __builtin_cpu_supports("avx2") != 0) return scanned_by_four(c, d);
#endif
    return farthest_one_by_one(c, d);
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
