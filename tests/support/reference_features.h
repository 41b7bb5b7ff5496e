// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reference_gap.h"

#include <limits>

/// Polytope against polytope by brute force: the cores that reference_gap grows by their radii.
namespace brink::support {

struct Nearest {
    Real squared = std::numeric_limits<Real>::infinity();
    Real3 on_a, on_b;

    void keep(const Real3& a, const Real3& b)
    {
        const Real3 d = b - a;
        const Real found = dot(d, d);
        if (found < squared) *this = {found, a, b};
    }
};

/// Nearest points of two cores that do not meet: every edge against every edge, every corner against every
/// face.
Nearest nearest_features(const Placed& a, const Placed& b);

/// Whether an edge of one pierces a triangle or meets a box of the other. Flat cores that only touch do not
/// count: their nearest features are at distance zero.
bool cores_meet(const Placed& a, const Placed& b);

struct Separation {
    Real along = -std::numeric_limits<Real>::infinity(); // negative: overlap
    Real3 normal;                                        // from A to B
};

/// The widest separation along face normals and cross products of edges: where cores overlap, minus the
/// depth.
Separation separating_axes(const Placed& a, const Placed& b);

} // namespace brink::support
