// SPDX-License-Identifier: BSD-3-Clause
#include "border_entry.h"
#include "pairs.h"

namespace brink {

Entry triangle_half_space(const Triangle& a, const HalfSpace& b, const Approach& m)
{
    return border_entry(a, b, m);
}

} // namespace brink
