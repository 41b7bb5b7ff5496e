// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "certificate.h"
#include "gjk.h"

namespace brink {

/// What of a body takes part in the closest approach.
struct Feature {
    enum class Kind : unsigned char { vertex, edge, face };
    Kind kind = Kind::vertex;
    V3 along; // edge: its direction; face: its normal, in either sense; unit
};

/// Those of A and of B.
struct Features {
    Feature of_a, of_b;
};

/// The axis that two features ask for, and the spin that keeps it right while the bodies turn: glued to a
/// face; following the common normal of two edges; staying at right angles to an edge and over a corner; at
/// rest between two corners. `v` leads from a point of one feature to one of the other; `towards` tells the
/// sense of a normal that has none. Zero where the features give no axis.
TurningAxis axis_between(const Feature& a, V3 rate_a, const Feature& b, V3 rate_b, V3 v, V3 towards);

/// The corners of two polytopes that GJK's simplex names, wherever the bodies have gone since.
class Corners {
public:
    Corners() = default;
    explicit Corners(const Simplex&);
    /// Whether the simplex named corners on both sides.
    bool known() const { return count_ > 0; }
    /// The features that they make, from the same simplex where its corners are now.
    Features features(const Simplex& now) const;
    /// That simplex.
    Simplex simplex(const Core& a, const Core& b) const
    {
        Simplex s;
        place(s, a, b);
        return s;
    }
    void place(Simplex&, const Core& a, const Core& b) const;

private:
    /// The places in the simplex of those that differ.
    struct Some {
        int count = 0;
        int place[4] = {};
        void add(const int* corners, int k);
    };
    Some of_a_, of_b_;
    int count_ = 0;
    int in_a_[4] = {}, in_b_[4] = {};
};

} // namespace brink
