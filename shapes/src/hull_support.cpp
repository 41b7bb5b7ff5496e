// SPDX-License-Identifier: BSD-3-Clause
#include "hull_data.h"

namespace brink {

namespace {

/// Up to so many corners looking at all of them is quicker than walking from one to the next.
constexpr int most_scanned = 64;
constexpr int lanes = 4;

/// Of all corners: in steps of four, each with its own best, so that nothing waits for the step before.
int scan(const HullData& h, V3 d)
{
    const int count = h.count();
    double best[lanes];
    int at[lanes];
    for (int i = 0; i < lanes; ++i)
        best[i] = -infinity, at[i] = 0;
    int k = 0;
    for (; k + lanes <= count; k += lanes) {
        for (int i = 0; i < lanes; ++i) {
            const double height = dot(h.corner(k + i), d);
            const bool higher = height > best[i];
            best[i] = higher ? height : best[i];
            at[i] = higher ? k + i : at[i];
        }
    }
    for (; k < count; ++k) {
        const double height = dot(h.corner(k), d);
        if (height > best[0]) best[0] = height, at[0] = k;
    }
    int winner = 0;
    for (int i = 1; i < lanes; ++i)
        if (best[i] > best[winner]) winner = i;
    return at[winner];
}

/// From corner to higher neighbour, to where there is none: on a convex polyhedron that is the highest.
/// Heights are told apart by the edge between, whose rounding is relative to its own length. Should rounding
/// lead round in a circle, it is a scan after all.
int climb(const HullData& h, V3 d)
{
    const auto at = [&](int k) { return static_cast<std::size_t>(k); };
    V3 corner = h.corner(0);
    int top = 0;
    for (int step = 0; step < h.count(); ++step) {
        const int last = h.first_neighbour[at(top + 1)];
        int i = h.first_neighbour[at(top)];
        while (i < last && !(dot(h.corner(h.neighbours[at(i)]) - corner, d) > 0))
            ++i;
        if (i == last) return top;
        top = h.neighbours[at(i)];
        corner = h.corner(top);
    }
    return scan(h, d);
}

} // namespace

int farthest(const HullData& h, V3 d)
{
    return h.count() <= most_scanned || h.neighbours.empty() ? scan(h, d) : climb(h, d);
}

} // namespace brink
