// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <real.h>

#include <brink/ccd.h>

#include <cstddef>
#include <vector>

namespace brink::bench {

/// Two moving hulls in long double, by brute force: every face plane and every pair of edges that forms a
/// face of the Minkowski difference. Shares nothing with brink. The corners of each hull must be in general
/// position: no four in one plane.
class HullsOverTime {
public:
    HullsOverTime(const Hull& a, const Motion&, const Hull& b, const Motion&);

    /// The widest separation along the normals of the Minkowski difference's faces: positive where the hulls
    /// are apart, then at most their distance; negative where they overlap.
    support::Real separation(support::Real t) const;

    /// No gap changes faster than this (length per step).
    support::Real fastest() const { return fastest_; }

    /// Distance of the pivots at the start, displacement, extents: what rounding is relative to.
    support::Real scale() const { return scale_; }

private:
    struct Face {
        support::Real3 normal; // outwards, unit
        std::size_t corner;    // one on it
    };
    struct Edge {
        std::size_t from, to, left, right; // corners, faces
    };
    struct Body {
        Body(const Hull&, const Motion&, const support::Real3& origin);
        std::vector<support::Real3> corners; // about the pivot, at the start
        std::vector<Face> faces;
        std::vector<Edge> edges;
        support::Real3 pivot, translation, axis;
        support::Real turn = 0, reach = 0;
        /// At time t, in the world about `origin`.
        Body at(support::Real t) const;
        void find_faces();
        void find_edges();
    };
    static support::Real beyond_faces(const Body& of, const Body& other);
    static support::Real beyond_edges(const Body& a, const Body& b);

    Body a_, b_;
    support::Real fastest_, scale_;
};

} // namespace brink::bench
