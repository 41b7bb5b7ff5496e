// SPDX-License-Identifier: BSD-3-Clause
#include "support.h"

namespace brink {

namespace {

/// The axes of a round core that reach from its centre to all of its points: no coordinate of them is larger
/// than the sum of these.
double solid_extent(const Core& c)
{
    const V3 h = c.half_extents, centre = magnitudes(c.centre);
    const V3 x = magnitudes(c.axes.x), y = magnitudes(c.axes.y), z = magnitudes(c.axes.z);
    return largest_coordinate(centre + h.x * x + h.y * y + h.z * z);
}

} // namespace

double extent(const Core& c)
{
    if (c.kind == Core::Kind::hull)
        return largest_coordinate(c.centre) + c.hull->reach * careful_norm(c.axes.x);
    if (c.kind >= Core::Kind::box) return solid_extent(c);
    double largest = 0;
    for (int k = 0; k < c.count; ++k)
        largest = std::max(largest, largest_coordinate(c.points[k]));
    return largest;
}

double reach(const Core& c)
{
    const V3 h = c.half_extents;
    if (c.kind == Core::Kind::hull) return norm(middle(c)) + c.hull->ball * careful_norm(c.axes.x);
    if (c.kind == Core::Kind::ellipsoid) return norm(c.centre) + largest_coordinate(h);
    if (c.kind == Core::Kind::box) { // the corner on the far side of the centre
        const V3 centre = into(c.axes, c.centre);
        return norm(magnitudes(centre) + h);
    }
    if (!is_polytope(c)) return norm(c.centre) + std::sqrt(h.x * h.x + h.z * h.z);
    double squared = 0;
    for (int k = 0; k < c.count; ++k)
        squared = std::max(squared, norm_squared(corner(c, k)));
    return std::sqrt(squared);
}

} // namespace brink
