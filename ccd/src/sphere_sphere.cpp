// SPDX-License-Identifier: BSD-3-Clause
#include "crossing.h"
#include "pairs.h"
#include "quadratic.h"

#include <bit>
#include <cstdint>

namespace brink {

namespace {

/// The sum of the radii and the target gap.
Pair reach_of(const Sphere& a, const Sphere& b, const Approach& m)
{
    const Pair radii = two_sum(a.radius, b.radius), sum = two_sum(radii.hi, m.target_gap);
    return {sum.hi, sum.lo + radii.lo};
}

/// x and y, z and the radius: four coordinates of a cone whose apex the point reaches when it touches.
struct Four {
    TwoPairs xy, zr;
};

/// A relative position and the radius, or a relative motion and 0, with what rounding left off them.
Four difference(const Vec3& a, const Vec3& b, Pair radius)
{
    const double *p = a.data(), *q = b.data();
    const TwoPairs xy = two_sum(Two{p[0], p[1]}, -Two{q[0], q[1]});
    const Pair z = two_difference(p[2], q[2]);
    return {xy, {Two{z.hi, radius.hi}, Two{z.lo, radius.lo}}};
}

TwoPairs moved(const TwoPairs& from, Two t, const TwoPairs& by)
{
    const TwoPairs product = two_product(t, by.hi), sum = two_sum(from.hi, product.hi);
    return {sum.hi, sum.lo + (product.lo + (from.lo + t * by.lo))};
}

/// x^2 + y^2 + z^2 - r^2, its terms taken exactly.
struct Clearance {
    double squared;
    Two dust; // zero where nothing was rounded
};
Clearance clearance(const TwoPairs& xy, const TwoPairs& zr)
{
    const TwoPairs high = two_product(xy.hi, xy.hi), low = two_product(zr.hi, zr.hi);
    const Two sign{1, -1};
    const TwoPairs sum = two_sum(high.hi, sign * low.hi);
    const Two rest = sum.lo + (high.lo + sign * low.lo) +
                     (xy.lo * (xy.hi + xy.hi + xy.lo) + sign * (zr.lo * (zr.hi + zr.hi + zr.lo)));
    const Pair all = two_sum(sum.hi[0], sum.hi[1]);
    const auto size = [](Two x) { return select(x < 0, -x, x); };
    return {all.hi + (all.lo + (rest[0] + rest[1])),
            size(xy.lo) + size(zr.lo) + size(high.lo) + size(low.lo) + size(sum.lo)};
}

double least(double a, double b) { return a < b ? a : b; }

/// The double below or above t + step, t > 0, by its last place at most.
double rounded_down(double t, double step)
{
    const Pair sum = two_sum(t, step);
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(sum.hi) - (sum.lo < 0 ? 1U : 0U));
}
double rounded_up(double t, double step)
{
    const Pair sum = two_sum(t, step);
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(sum.hi) + (sum.lo > 0 ? 1U : 0U));
}

/// A root of |from + t by|^2 = radius^2 to the last few places, from one that is off by any rounding: how far
/// the point is from the sphere at that time, taken exactly, over how fast it nears it.
[[gnu::always_inline]] inline Entry polished(double t, const Approach& m, Pair radius, double lengths)
{
    const Four from = difference(m.motion_a.start.position, m.motion_b.start.position, radius);
    const Four by = difference(m.motion_a.translation, m.motion_b.translation, {});
    const TwoPairs xy = moved(from.xy, both(t), by.xy), zr = moved(from.zr, both(t), by.zr);
    const Clearance over = clearance(xy, zr);
    const Two terms = xy.hi * by.xy.hi + zr.hi * by.zr.hi;
    const double nearing = -(terms[0] + terms[1]), share = 1 / nearing;
    const double travel = sum_of_magnitudes(m.by), pace = radius.hi * share; // over cos(angle of incidence)
    const double step = 0.5 * over.squared * share, bend = std::fabs(step * norm_squared(m.by) * share);
    const double doubt = tolerance::polish_slack * lengths * pace +
                         std::fabs(step) * (bend + tolerance::rounded_step * travel * pace);
    if (!(nearing > 0 && bend < tolerance::largest_bend && doubt <= tolerance::sharp_root * t)) return {};
    const bool at_it = over.squared == 0 && over.dust[0] + over.dust[1] == 0 && t <= m.t_max;
    const double first = at_it ? t : rounded_down(t, step - doubt),
                 last = at_it ? t : rounded_up(t, step + doubt);
    if (first > m.t_max) return {.found = Found::apart};
    const V3 centre = m.from + first * m.by,
             facing = radius.hi > tolerance::point_noise * lengths ? -centre : m.by;
    return {last > m.t_max ? Found::doubt : Found::hit, first, last, Meeting{centre, {}, facing, false}};
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
    if (!(c > tolerance::cancelled * distance_squared)) {
        const Four from = difference(m.motion_a.start.position, m.motion_b.start.position, radius);
        c = clearance(from.xy, from.zr).squared;
        const double doubt = tolerance::cancelled_slack * distance_squared;
        if (c < -doubt) return {.found = Found::start};
        if (!(c > doubt)) return {};
    }
    const double along = dot(m.from, m.by), speed_squared = norm_squared(m.by);
    const double lengths = sum_of_magnitudes(m.from) + radius.hi,
                 all_lengths = lengths + sum_of_magnitudes(m.by);
    const double ring = tolerance::ring * lengths;
    const double discriminant = speed_squared * reach_squared - norm_squared(cross(m.from, m.by));
    const double doubt = speed_squared * ring * (radius.hi + radius.hi + ring) + tolerance::nothing;
    const double turning = along + speed_squared * m.t_max, at_end = c + (along + turning) * m.t_max;
    const double end = tolerance::end_slack * squared(all_lengths) - at_end;
    // Not receding, not passing, not short of it at the end: as one number, for one branch.
    if (least(least(-along - tolerance::nothing, discriminant + doubt), turning > end ? turning : end) < 0)
        return {.found = Found::apart};
    if (!(discriminant > doubt)) return {};
    const double t = c / (std::sqrt(discriminant) - along);
    return polished(t, m, radius, all_lengths);
}

} // namespace brink
