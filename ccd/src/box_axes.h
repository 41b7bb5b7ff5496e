// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_features.h"

namespace brink {

/// A separating axis of two boxes, by what it is at right angles to.
struct BoxAxis {
    double gap = -infinity; // a lower bound of their distance, up to rounding
    V3 normal;              // unit, from A towards B
    int index = 0; // 0 to 2: a face of A, 3 to 5: of B, 6 + 3 i + j: edges along axis i of A and j of B
};

/// The separating axis test: the best of all 15 but those of edges nearly parallel, beside which a face does
/// as well. (S. Gottschalk, M. Lin, D. Manocha, OBBTree, 1996.)
BoxAxis box_axis(const Core& a, const Core& b);

/// The features of that axis wherever the boxes have gone since.
Features box_features(const Core& a, const Core& b, int index);

/// Points of the two features that come nearest; with good luck of the boxes. Their distance bounds that of
/// the boxes from above in any case.
struct BoxWitness {
    V3 point_a, v; // v leads to a point of B
};
BoxWitness box_witness(const Core& a, const Core& b, int index, V3 normal);

} // namespace brink
