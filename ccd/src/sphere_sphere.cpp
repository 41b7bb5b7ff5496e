// SPDX-License-Identifier: BSD-3-Clause
#include "pairs.h"
#include "quadratic.h"
#include "tolerance.h"

namespace brink {

namespace {

/// |from|^2 - radius^2 to nearly twice the working precision (Ogita, Rump and Oishi 2005), from what the
/// poses and radii say before rounding: near touching, what cancels in it is all the distance there is.
[[gnu::noinline]] double clearance_squared(const Sphere& a, const Sphere& b, const Approach& m)
{
    const V3 high = m.from, low = m.from_low();
    const Pair radii = two_sum(a.radius, b.radius), sum = two_sum(radii.hi, m.target_gap);
    const double radius_low = sum.lo + radii.lo;
    const Pair x = two_product(high.x, high.x), y = two_product(high.y, high.y),
               z = two_product(high.z, high.z);
    const Pair r = two_product(sum.hi, sum.hi);
    const Pair xy = two_sum(x.hi, y.hi), zr = two_difference(z.hi, r.hi), all = two_sum(xy.hi, zr.hi);
    const double rest = (x.lo + y.lo) + (z.lo - r.lo) + 2 * (dot(high, low) - sum.hi * radius_low);
    return all.hi + (all.lo + xy.lo + zr.lo + rest);
}

} // namespace

/// The centre of A against the ball of both radii about B's (Ericson, Real-Time Collision Detection, 2005).
Entry sphere_sphere(const Sphere& a, const Sphere& b, const Approach& m)
{
    const double radius = a.radius + b.radius + m.target_gap;
    const double distance_squared = norm_squared(m.from);
    double c = distance_squared - radius * radius;
    if (c < tolerance::cancelled * distance_squared) c = clearance_squared(a, b, m);
    if (c <= 0) return {.t = 0};
    const double across = norm_squared(cross(m.from, m.by));
    const double t = first_root(dot(m.from, m.by), c, norm_squared(m.by) * (radius * radius) - across);
    return {t, m.from + t * m.by, {}, m.by, false};
}

} // namespace brink
