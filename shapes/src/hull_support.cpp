// SPDX-License-Identifier: BSD-3-Clause
#include "hull_data.h"
#include "lanes.h"

namespace brink {

namespace {

/// Up to so many corners looking at all of them is quicker than walking from one to the next.
constexpr int most_scanned = 64;

/// The highest corners so far, two side by side, and which those are.
struct Top {
    Two height = both(-infinity), corner{};

    void look(Two other, Two at)
    {
        corner = select(other > height, at, corner);
        height = larger(other, height);
    }
};

/// Of all corners: by two, each with its own best, so that nothing waits for the step before.
int scan(const HullData& h, V3 d)
{
    const int count = h.count();
    const XYZ<Two> way = both(d);
    const double *x = h.x.data(), *y = h.y.data(), *z = h.z.data();
    const auto heights = [&](int k) {
        return dot(XYZ<Two>{load_two(x + k), load_two(y + k), load_two(z + k)}, way);
    };
    Top even, odd;
    Two at{0, 1};
    int k = 0;
    for (; k + 4 <= count; k += 4) {
        even.look(heights(k), at);
        odd.look(heights(k + 2), at + both(2));
        at = at + both(4);
    }
    if (k + 2 <= count) even.look(heights(k), at), k += 2;
    const TwoFlags later = odd.height > even.height;
    const Two height = select(later, odd.height, even.height),
              corner = select(later, odd.corner, even.corner);
    const bool second = height[1] > height[0];
    const double highest = second ? height[1] : height[0];
    const int best = static_cast<int>(second ? corner[1] : corner[0]);
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
    const auto at = [&](int k) { return static_cast<std::size_t>(k); };
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

} // namespace brink
