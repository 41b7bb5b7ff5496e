// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"

namespace brink {

/// Where a ray enters a shape from outside; t infinite where it does not.
struct SurfaceEntry {
    double t = infinity; // in lengths of the direction
    V3 point, normal;    // on the shape; out of it, towards the ray
};

/// A ray from outside into a cylinder, a cone or an ellipsoid whose radii are not zero: quadratics in the
/// shape's own frame. Lengths such that products of six neither overflow nor vanish.
SurfaceEntry enter_round(V3 origin, V3 direction, const Core&);

} // namespace brink
