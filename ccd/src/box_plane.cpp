// SPDX-License-Identifier: BSD-3-Clause
#include "border_entry.h"
#include "pairs.h"

namespace brink {

Entry box_plane(const Box& a, const Plane& b, const Approach& m) { return border_entry(a, b, m); }

} // namespace brink
