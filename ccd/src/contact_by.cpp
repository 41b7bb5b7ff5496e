// SPDX-License-Identifier: BSD-3-Clause
#include "contact_by.h"

#include "depth.h"
#include "tolerance.h"
#include "trend.h"

#include <algorithm>

namespace brink {

namespace {

/// Whether the witness points, which go with their bodies, prove contact at a later time, or else four
/// corners of the difference do.
bool in_contact(Course<Core>& course, const Watch& watch, const Sight& sight, double later)
{
    const Facing<Core>& f = course.facing();
    const auto at = course.later(later);
    const V3 a = at.turn_a * sight.point_a;
    const V3 b = at.turn_b * (sight.point_a + sight.v - f.b.pivot) + at.pivot_b;
    const double doubt = course.rounding + sight.astray;
    if (course.radii > 0) return norm(b - a) + doubt <= course.radii;
    // Each body stays where it is, and the other's point goes where it will be beside it.
    const V3 beside_b = into(at.turn_b, a - at.pivot_b) + f.b.pivot;
    if (depth(f.b.part, beside_b) > doubt) return true;
    if (depth(f.a.part, into(at.turn_a, b)) > doubt) return true;
    const double now = course.now();
    course.go(later);
    const bool proven = watch.overlap(f, course.rounding);
    course.go(now);
    return proven;
}

bool in_contact(Course<Border>& course, const BorderWatch&, const Sight&, double later)
{
    const double now = course.now();
    course.go(later);
    const double gap = course.separated().gap;
    course.go(now);
    return gap + course.rounding <= course.options.target_gap;
}

template <class Part, class WatchOfPart>
double proven_contact(Course<Part>& course, const WatchOfPart& watch, const Sight& sight)
{
    const V3 n = sight.best_normal();
    const double closing =
        -trend(course.facing(), {n, sight.axis.spin}, sight.point_a, sight.point_a + sight.v).rate;
    const double gap = std::max(0.0, dot(sight.v, n) - course.radii);
    if (!(closing > 0)) return infinity;
    for (const double deep :
         {tolerance::shallow * course.rounding, 2 * course.tolerance + tolerance::deeper * course.rounding}) {
        const double later = std::min(course.now() + 2 * (gap + deep) / closing, course.options.t_max);
        if (in_contact(course, watch, sight, later)) return later;
    }
    return infinity;
}

} // namespace

double contact_by(Course<Core>& course, const Watch& watch, const Sight& sight)
{
    return proven_contact(course, watch, sight);
}
double contact_by(Course<Border>& course, const BorderWatch& watch, const Sight& sight)
{
    return proven_contact(course, watch, sight);
}

} // namespace brink
