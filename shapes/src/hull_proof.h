// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hull_proposal.h"

namespace brink {

/// The sign of det(b - a, c - a, p - a), exactly: 1 where the triangle abc is seen from p counterclockwise,
/// -1 where clockwise, 0 where p lies in its plane. Coordinates less than 2. (Filter as in J. Shewchuk,
/// Adaptive Precision Floating-Point Arithmetic, 1997.)
int side(V3 a, V3 b, V3 c, V3 p);

/// Triangles proven to be a closed surface, all of them turned away from one point: whatever lies on no
/// outer side of any of them lies in the hull of their corners.
///
/// Proof: a point outside of the hull is one that the surface does not go round, so a line from it through
/// the surface crosses it as often inwards as outwards, and at least once inwards; it begins on the outer
/// side of what it crosses inwards.
class Surface {
public:
    /// Empty where that is not so.
    Surface(const std::vector<V3>& points, std::vector<Facet> faces);

    bool empty() const { return faces_.empty(); }
    bool holds(V3 point) const;
    /// Whether it is proven to be the boundary of the hull of its corners, each of which is a corner indeed,
    /// or lies on an edge: from any other than the highest, along whatever direction, an edge leads up.
    bool convex() const;
    const std::vector<Facet>& faces() const { return faces_; }
    /// How many corners it has, if convex (Euler).
    std::size_t corner_count() const { return faces_.size() / 2 + 2; }

private:
    struct Edge {
        int from, to, face, apex;
    };
    struct Plane {
        V3 normal; // not unit
        double offset;
    };

    V3 at(int k) const { return points_[static_cast<std::size_t>(k)]; }
    bool turn_outwards();
    bool pair_edges();
    bool goes_round_once() const;
    bool has_flat_corner() const;
    Edge opposite(const Edge&) const;

    const std::vector<V3>& points_;
    std::vector<Facet> faces_;
    std::vector<Edge> edges_; // by their ends
    std::vector<Plane> planes_;
    V3 middle_;
    double inner_ = 0; // the square of the radius of a ball about the middle that they hold
};

} // namespace brink
