// SPDX-License-Identifier: BSD-3-Clause
#include "pairs.h"
#include "quadratic.h"

namespace brink {

namespace {

/// |high + low|^2 - radius^2 to nearly twice the working precision (Ogita, Rump and Oishi 2005): near
/// touching, what cancels in it is all the distance there is.
double clearance_squared(V3 high, V3 low, Pair radius)
{
    const Pair x = two_product(high.x, high.x), y = two_product(high.y, high.y),
               z = two_product(high.z, high.z);
    const Pair r = two_product(radius.hi, radius.hi);
    const Pair xy = two_sum(x.hi, y.hi), zr = two_difference(z.hi, r.hi), all = two_sum(xy.hi, zr.hi);
    const double rest = (x.lo + y.lo) + (z.lo - r.lo) + 2 * (dot(high, low) - radius.hi * radius.lo);
    return all.hi + (all.lo + xy.lo + zr.lo + rest);
}

} // namespace

/// The centre of A against the ball of both radii about B's (Ericson, Real-Time Collision Detection, 2005).
Entry sphere_sphere(const Sphere& a, const Sphere& b, const Approach& m)
{
    const Pair radii = two_sum(a.radius, b.radius);
    const Pair sum = two_sum(radii.hi, m.target_gap);
    const Pair radius{sum.hi, sum.lo + radii.lo};

    const double c = clearance_squared(m.from, m.from_low(), radius);
    if (c <= 0) return {.t = 0};
    const double along = dot(m.from, m.by);
    const double across = norm_squared(cross(m.from, m.by));
    const double t = first_root(along, c, norm_squared(m.by) * (radius.hi * radius.hi) - across);
    return {t, m.from + t * m.by, {}, m.by, false};
}

} // namespace brink
