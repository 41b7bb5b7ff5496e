// SPDX-License-Identifier: BSD-3-Clause
#include "hull_data.h"
#include "lanes.h"

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

/// Of the corners looked at by four: each place among four with its own best, so that nothing waits for the
/// step before.
struct Tops {
    Top even, odd;
};

Two heights(const HullData& h, V3 d, int k)
{
    return dot(XYZ<Two>{load_two(&h.x[at(k)]), load_two(&h.y[at(k)]), load_two(&h.z[at(k)])}, both(d));
}

Tops by_two(const HullData& h, const V3& d)
{
    Tops t;
    Two corners{0, 1};
    for (int k = 0; k + 4 <= h.count(); k += 4) {
        t.even.look(heights(h, d, k), corners);
        t.odd.look(heights(h, d, k + 2), corners + both(2));
        corners = corners + both(4);
    }
    return t;
}

#ifdef __x86_64__
/// The same, bit for bit, in one wide register.
[[gnu::target("avx2")]] Tops by_four(const HullData& h, const V3& d)
{
    const double *x = h.x.data(), *y = h.y.data(), *z = h.z.data();
    const __m256d dx = _mm256_set1_pd(d.x), dy = _mm256_set1_pd(d.y), dz = _mm256_set1_pd(d.z);
    __m256d height = _mm256_set1_pd(-infinity), corner{}, corners{0, 1, 2, 3};
    for (int k = 0; k + 4 <= h.count(); k += 4) {
        const __m256d other =
            _mm256_loadu_pd(x + k) * dx + _mm256_loadu_pd(y + k) * dy + _mm256_loadu_pd(z + k) * dz;
        corner = _mm256_blendv_pd(corner, corners, _mm256_cmp_pd(other, height, _CMP_GT_OQ));
        height = _mm256_max_pd(other, height);
        corners += 4;
    }
    return {Top{_mm256_castpd256_pd128(height), _mm256_castpd256_pd128(corner)},
            Top{_mm256_extractf128_pd(height, 1), _mm256_extractf128_pd(corner, 1)}};
}
bool has_four() { return __builtin_cpu_supports("avx2") != 0; }
#else
Tops by_four(const HullData& h, const V3& d) { return by_two(h, d); }
bool has_four() { return false; }
#endif

/// Of all corners.
int scan(const HullData& h, const V3& d)
{
    const int count = h.count();
    auto [even, odd] = has_four() ? by_four(h, d) : by_two(h, d);
    int k = count & ~3;
    if (k + 2 <= count) even.look(heights(h, d, k), Two{0, 1} + both(k)), k += 2;
    const TwoFlags later = odd.height > even.height;
    const Two height = select(later, odd.height, even.height),
              corner = select(later, odd.corner, even.corner);
    const Two other = both(height[1]); // no branch here: nobody can predict it
    const TwoFlags second = other > height;
    const double highest = larger(other, height)[0];
    const int best = static_cast<int>(select(second, both(corner[1]), corner)[0]);
    if (k < count && dot(h.corner(k), d) > highest) return k;
    return best;
}

/// The highest of every so-manieth corner.
int sample(const HullData& h, V3 d, int stride)
{
    int best = 0;
    double highest = dot(h.corner(0), d);
    for (int k = stride; k < h.count(); k += stride) {
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
    int top = sample(h, d, h.count() / most_scanned);
    for (int step = 0; step < h.count(); ++step) {
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

int farthest(const HullData& h, V3 d)
{
    return h.count() <= most_scanned || h.neighbours.empty() ? scan(h, d) : climb(h, d);
}

double depth(const HullData& h, V3 point)
{
    Two least = both(h.face_offset.empty() ? 0 : infinity);
    for (std::size_t k = 0; k < h.face_offset.size(); k += 2) {
        const XYZ<Two> n{load_two(&h.face_x[k]), load_two(&h.face_y[k]), load_two(&h.face_z[k])};
        least = smaller(load_two(&h.face_offset[k]) - dot(n, both(point)), least);
    }
    return least[1] < least[0] ? least[1] : least[0];
}

} // namespace brink
