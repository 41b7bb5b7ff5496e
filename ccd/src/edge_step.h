// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "certificate.h"

namespace brink {

/// What the axis at right angles to an edge of each body proves, as it goes with both: they pass each other
/// where the edges are nearest, and only what these points do bends the gap between the edges. The edges are
/// those that lie flattest along `normal`. Nothing of cores without corners or with too many.
Step edge_step(const Facing<Core>&, V3 normal, double horizon);

} // namespace brink
