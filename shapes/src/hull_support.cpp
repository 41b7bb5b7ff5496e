// SPDX-License-Identifier: BSD-3-Clause
#include "hull_data.h"

namespace brink {

namespace {

/// Up to so many corners looking at all of them is quicker than walking from one to the next.
constexpr int most_scanned = 64;
constexpr int lanes = 4;

/// Of every so-manieth corner: in steps of four, each with its own best, so that nothing waits for the step
/// before.
int scan(const HullData& h, V3 d, int stride)
{
    const int count = h.count();
    double best[lanes];
    int at[lanes];
    for (int i = 0; i < lanes; ++i)
        best[i] = -infinity, at[i] = 0;
    int k = 0;
    for (; k + (lanes - 1) * stride < count; k += lanes * stride) {
        for (int i = 0; i < lanes; ++i) {
            const double height = dot(h.corner(k + i * stride), d);
            const bool higher = height > best[i];
            best[i] = higher ? height : best[i];
            at[i] = higher ? k + i * stride : at[i];
        }
    }
    for (; k < count; k += stride) {
        const double height = dot(h.corner(k), d);
        if (height > best[0]) best[0] = height, at[0] = k;
    }
    int winner = 0;
    for (int i = 1; i < lanes; ++i)
        if (best[i] > best[winner]) winner = i;
    return at[winner];
}

/// From corner to highest neighbour, to where none is higher: on a convex polyhedron that is the highest of
/// all. Heights are told apart by the edge between, whose rounding is relative to its own length. Should
/// rounding lead round in a circle, it is a scan after all.
int climb(const HullData& h, V3 d)
{
    const auto at = [&](int k) { return static_cast<std::size_t>(k); };
    int top = scan(h, d, h.count() / most_scanned);
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
    return scan(h, d, 1);
}

} // namespace

int farthest(const HullData& h, V3 d)
{
    return h.count() <= most_scanned || h.neighbours.empty() ? scan(h, d, 1) : climb(h, d);
}

} // namespace brink
