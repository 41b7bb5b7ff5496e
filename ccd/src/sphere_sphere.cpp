// SPDX-License-Identifier: BSD-3-Clause
#include "crossing.h"
#include "pairs.h"
#include "quadratic.h"

namespace brink {

namespace {

/// The sum of the radii and the target gap.
Pair reach_of(const Sphere& a, const Sphere& b, const Approach& m)
{
    const Pair radii = two_sum(a.radius, b.radius), sum = two_sum(radii.hi, m.target_gap);
    return {sum.hi, sum.lo + radii.lo};
}

/// |hi + low|^2 - radius^2, its terms taken exactly (T. Ogita, S. Rump and S. Oishi 2005).
[[gnu::always_inline]] inline double clearance_squared(V3 hi, V3 low, Pair radius)
{
    const Pair x = two_product(hi.x, hi.x), y = two_product(hi.y, hi.y), z = two_product(hi.z, hi.z);
    const Pair r = two_product(radius.hi, radius.hi);
    const Pair xy = two_sum(x.hi, y.hi), zr = two_difference(z.hi, r.hi), all = two_sum(xy.hi, zr.hi);
    const double rest = dot(low, hi + hi + low) - radius.lo * (radius.hi + radius.hi + radius.lo);
    return all.hi + ((all.lo + (xy.lo + zr.lo)) + ((x.lo + y.lo) + (z.lo - r.lo) + rest));
}

/// A root of |from + t by|^2 = radius^2 to the last few places, from one that is off by any rounding: how far
/// the point is from the sphere at that time, taken exactly, over how fast it nears it.
[[gnu::always_inline]] inline Entry polished(double t, const Approach& m, Pair radius)
{
    const V3 high = m.from, by = m.by, from_low = m.from_low(), by_low = m.by_low();
    const auto along = [t](double f, double d, double f_low, double d_low) {
        const Pair moved = two_product(t, d), sum = two_sum(f, moved.hi);
        return Pair{sum.hi, sum.lo + (moved.lo + (f_low + t * d_low))};
    };
    const Pair x = along(high.x, by.x, from_low.x, by_low.x), y = along(high.y, by.y, from_low.y, by_low.y),
               z = along(high.z, by.z, from_low.z, by_low.z);
    const V3 at{x.hi, y.hi, z.hi};
    const double over = clearance_squared(at, {x.lo, y.lo, z.lo}, radius), nearing = -dot(at, by);
    const double travel = sum_of_magnitudes(by), lengths = sum_of_magnitudes(high) + travel + radius.hi;
    const double pace = radius.hi / nearing; // over cos(angle of incidence)
    const double step = over / (nearing + nearing), bend = std::fabs(step * norm_squared(by) / nearing);
    const double doubt = tolerance::polish_slack * lengths * pace +
                         std::fabs(step) * (bend + tolerance::rounded_step * travel * pace);
    if (!(nearing > 0 && bend < tolerance::largest_bend && doubt <= tolerance::sharp_root * t)) return {};
    const double first = (t + (step - doubt)) * tolerance::downwards,
                 last = (t + (step + doubt)) * tolerance::upwards;
    if (first > m.t_max) return {.found = Found::apart};
    const bool late = last > m.t_max;
    return {late ? Found::doubt : Found::hit,
            first,
            late ? infinity : last,
            late,
            m.from + first * by,
            {},
            by,
            false};
}

} // namespace

/// The centre of A against the ball of both radii about B's (Ericson, Real-Time Collision Detection, 2005).
/// Whether the path meets the ball is decided in plain double arithmetic when balls a little smaller and a
/// little larger agree.
Entry sphere_sphere(const Sphere& a, const Sphere& b, const Approach& m)
{
    const Pair radius = reach_of(a, b, m);
    const double distance_squared = norm_squared(m.from), reach_squared = radius.hi * radius.hi;
    double c = distance_squared - reach_squared;
    if (c < tolerance::cancelled * distance_squared) {
        c = clearance_squared(m.from, m.from_low(), radius);
        const double doubt = tolerance::cancelled_slack * distance_squared;
        if (c < -doubt) return {.found = Found::start};
        if (c < doubt) return {};
    }
    const double along = dot(m.from, m.by);
    if (along >= 0) return {.found = Found::apart};
    const double speed_squared = norm_squared(m.by), across = norm_squared(cross(m.from, m.by));
    const double ring = tolerance::ring * (sum_of_magnitudes(m.from) + radius.hi);
    const double discriminant = speed_squared * reach_squared - across;
    const double doubt = speed_squared * ring * (radius.hi + radius.hi + ring) + tolerance::nothing;
    if (discriminant < -doubt) return {.found = Found::apart};
    if (!(discriminant > doubt)) return {};
    const double t = c / (std::sqrt(discriminant) - along);
    if (t > 2 * m.t_max) return {.found = Found::apart};
    return polished(t, m, radius);
}

} // namespace brink
