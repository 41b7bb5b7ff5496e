// SPDX-License-Identifier: BSD-3-Clause
#include "depth.h"

#include "hull_data.h"

#include <algorithm>

namespace brink {

double depth(const Core& c, V3 point)
{
    const V3 p = into(c.axes, point - c.centre), h = c.half_extents;
    const double across = std::sqrt(p.x * p.x + p.y * p.y);
    switch (c.kind) {
    case Core::Kind::box:
        return std::min({h.x - std::fabs(p.x), h.y - std::fabs(p.y), h.z - std::fabs(p.z)});
    case Core::Kind::cylinder:
        return std::min(h.z - std::fabs(p.z), h.x - across);
    case Core::Kind::cone: { // the base, and the side, which falls by 2 h.z over h.x
        const double slant = std::sqrt(h.x * h.x + 4 * h.z * h.z);
        const double side = slant > 0 ? ((h.z - p.z) * h.x - 2 * h.z * across) / slant : -across;
        // The cylinder around it: of a disc, a line or a point the side alone leaves the ends open.
        return std::min({h.z + p.z, side, h.x - across, h.z - p.z});
    }
    case Core::Kind::ellipsoid: { // a part of the way out that is left in every direction
        const V3 q{p.x / h.x, p.y / h.y, p.z / h.z};
        return (1 - norm(q)) * std::min({h.x, h.y, h.z});
    }
    case Core::Kind::hull: { // whose axes are as long as its unit
        const double unit = norm(c.axes.x);
        return unit * depth(*c.hull, (1 / (unit * unit)) * p);
    }
    default:
        return -infinity;
    }
}

} // namespace brink
