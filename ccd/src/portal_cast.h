// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "approach.h"
#include "core.h"

namespace brink {

/// First contact of two polytopes without radius under translation, given in their own frames: where the path
/// pierces the surface of their difference, found by portal refinement (G. Snethen, XenoCollide, 2008) along
/// the path and proven along the face met. What has a radius or a target gap, or is flat, is left in doubt.
Entry portal_cast(const Core& a, const Core& b, const Approach&);

} // namespace brink
