// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"
#include "hull_data.h"

namespace brink {

/// How deep a point lies inside a core, at least: no ball of that radius about it reaches out. Negative
/// outside, or where the faces of a hull are not known, and -infinity where a core has no inside.
double depth(const Core&, V3 point);

/// Asks the memory for what that reads.
static inline void expect_depth(const Core& c)
{
    if (c.kind == Core::Kind::hull) expect(c.hull->faces);
}

} // namespace brink
