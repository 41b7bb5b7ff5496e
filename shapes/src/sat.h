// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"

namespace brink {

/// A direction and the gap between the supporting planes of two cores at right angles to it.
struct Axis {
    double gap = -infinity; // negative: minus how far B must move along `normal` to be clear of A
    V3 normal;              // unit, from A towards B
};

/// The separating axis test, radii left out: of all normals of the faces of the difference B - A (face
/// normals of both, and edge x edge) the one with the largest gap. Cores that overlap have a penetration
/// depth of exactly -gap, which is 0 for two flat ones in one plane. For cores apart, gap is a lower bound of
/// their distance. (S. Gottschalk, M. Lin, D. Manocha, OBBTree, 1996; each axis is a valid bound, so rounding
/// cannot mislead.)
Axis separating_axis(const Core& a, const Core& b);

/// The directions of the edges of a core that have a length, and the normals of its faces. Not of unit
/// length.
struct Directions {
    int edges = 0, faces = 0;
    V3 edge[3], face[3];
};
Directions directions(const Core&);

} // namespace brink
