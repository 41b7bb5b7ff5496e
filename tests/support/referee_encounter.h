// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query.h"
#include "referee_features.h"

#include <vector>

namespace brink::support {

/// A plane or half-space, in its own frame, and the core that moves over it.
struct Ground {
    Digits3 normal; // as given: not of unit length
    Digits offset;
    bool two_sided = false;
    std::vector<Digits3> feet; // the core's corners about the moving point
};

/// Of the lowest and the highest corner, times the length of the normal, when the moving point is at p.
struct Heights {
    Digits low, high;
};
Heights heights(const Ground&, const Digits3& p);

/// A query as the referee sees it: in the frame of the shape that stands later in the variant, a point moves
/// towards a rounded core or ground. Two capsules become a point and a rounded parallelogram.
struct Encounter {
    Ray ray;
    Digits radius; // both radii and the target gap
    std::vector<Feature> features;
    std::optional<Digits3> half;  // a solid box, which the features bound
    std::optional<Ground> ground; // in place of features
    Digits scale;                 // S of design promise 3
    bool swapped = false;         // the point is B
    Digits33 frame;               // its axes in the world
};

Encounter encounter(const Query&);

/// How the point stands at a time.
struct Standing {
    Digits gap; // minus target_gap; signed
    bool contact = false;
    bool exact = false; // `contact` was decided without rounding
};
Standing standing(const Encounter&, const Digits& t);

} // namespace brink::support
