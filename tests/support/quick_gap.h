// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "quick_body.h"

/// The gap of two placed cores in doubles, from both sides: two points that exist bound it from above and two
/// supporting planes from below. Good to the rounding of placing and of a few sums.
namespace brink::support {

struct QuickGap {
    double lower = 0, upper = 0; // between the cores; radii do not count
    Quick3 normal;               // unit, from A to B
    Quick3 point_a, point_b;     // of the cores, from their pivots
    Quick3 edge_a, edge_b; // between two points of a core that the nearest point lies between; else zero
    bool overlap =
        false; // the cores hold a common point: how deep is not known, and `lower` is -infinity, `upper` 0
};

/// When the bounds are near enough.
struct QuickEffort {
    double enough = 0;           // a length, or ...
    double share = 0, level = 0; // ... this share of how far the lower bound is above the level; with a share
                                 // an upper bound that is not above the level is enough too
};

/// By GJK (E. Gilbert, D. Johnson, S. Keerthi 1988), from a direction from A to B; any will do. One of the
/// two may be ground.
QuickGap quick_gap(const QuickPlace& a, const QuickPlace& b, const Quick3& hint, const QuickEffort&);

/// The least of n . b - n . a over two bounded cores: not above the gap for a unit normal. Over ground only
/// if n is its normal, or of a plane the opposite; -infinity else.
double quick_separation(const QuickPlace& a, const QuickPlace& b, const Quick3& n);

/// How far a point (from the pivot of the placed body) is from the core; of ground, how far above it.
double quick_distance(const QuickPlace&, const Quick3& point, double enough);

} // namespace brink::support
