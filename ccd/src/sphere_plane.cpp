// SPDX-License-Identifier: BSD-3-Clause
#include "border_entry.h"
#include "pairs.h"

namespace brink {

Entry sphere_plane(const Sphere& a, const Plane& b, const Approach& m)
{
    const V3 centre[] = {m.from};
    return border_entry(centre, border_of(b, m), m, a.radius + m.target_gap, 0);
}

} // namespace brink
