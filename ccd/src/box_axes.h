// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_features.h"

namespace brink {

/// The best separating axis of two boxes.
struct BoxAxis {
    double gap = -infinity; // a lower bound of their distance, up to rounding
    V3 normal;              // unit, from A towards B
    Feature a, b;           // the face, or the two edges, that it belongs to
};

/// The separating axis test: all 15 but those of edges nearly parallel, beside which a face does as well. (S.
/// Gottschalk, M. Lin, D. Manocha, OBBTree, 1996.)
BoxAxis box_axis(const Core& a, const Core& b);

/// Points of the two features that come nearest; with good luck of the boxes. Their distance bounds that of
/// the boxes from above in any case.
struct Witness {
    V3 point_a, v; // v leads to a point of B
};
Witness box_witness(const Core& a, const Core& b, const BoxAxis&);

} // namespace brink
