// SPDX-License-Identifier: BSD-3-Clause
#include "contact_by.h"

#include "depth.h"
#include "piercing.h"
#include "support.h"
#include "tolerance.h"
#include "trend.h"

#include <algorithm>

namespace brink {

namespace {

/// Where a point of each body will be beside the other one, as that is placed now.
struct Beside {
    V3 a, b;
    double doubt; // beyond rounding
};

/// Over times in which paths hardly bend, along the velocities.
Beside beside(const Course<Core>& course, V3 a, V3 b, double later)
{
    const Facing<Core>& f = course.facing();
    const double h = later - course.now(), turning = f.a.angle + f.b.angle;
    // Of either point seen from the other body: its own and Coriolis' acceleration, and the centrifugal one.
    const double bend = turning * (3 * course.fastest + turning * (norm(b - a) + 2 * h * course.fastest));
    const double bent = 0.5 * bend * h * h;
    if (bent <= course.rounding) {
        const V3 to_a = f.velocity + cross(f.b.rate, a - f.b.pivot) - cross(f.a.rate, a);
        const V3 to_b = f.velocity + cross(f.b.rate, b - f.b.pivot) - cross(f.a.rate, b);
        return {a - h * to_a, b + h * to_b, bent};
    }
    const auto at = course.later(later);
    const V3 later_b = at.turn_b * (b - f.b.pivot) + at.pivot_b;
    return {into(at.turn_b, at.turn_a * a - at.pivot_b) + f.b.pivot, into(at.turn_a, later_b), 0};
}

/// Whether the witness points, which go with their bodies, prove contact at a later time.
bool in_contact(const Course<Core>& course, const Sight& sight, double later)
{
    const Facing<Core>& f = course.facing();
    const V3 on_b = sight.point_a + sight.v;
    const Beside gone = beside(course, sight.point_a, on_b, later);
    const double doubt = course.rounding + sight.astray + gone.doubt;
    if (course.radii > 0) return norm(on_b - gone.a) + doubt <= course.radii;
    return depth(f.b.part, gone.a) > doubt || depth(f.a.part, gone.b) > doubt;
}
bool in_contact(Course<Border>& course, const Sight& sight, double later)
{
    const Facing<Border>& f = course.facing();
    const V3 p = sight.point_a;
    const double h = later - course.now(), speed = norm(f.velocity) + f.a.angle * norm(p);
    const Drift d = drift(f.a, f.b, -f.velocity, p, norm(p - f.b.pivot) + h * speed);
    const double bent = 0.5 * d.acceleration * h * h, doubt = course.rounding + bent;
    // The other side of the body must not have passed the plane by then.
    const V3 n = sight.normal, other = farthest(f.a.part, -n).point;
    const bool holds = f.b.part.solid || sight.upper + dot(n, p - other) > h * course.fastest;
    if (bent <= course.rounding && holds) return sight.upper - h * dot(n, d.velocity) + doubt <= course.radii;
    const double now = course.now();
    course.go(later);
    const double gap = course.separated().gap;
    course.go(now);
    return gap + course.rounding <= course.options.target_gap;
}

/// Whether four corners of the difference prove it, which takes longer.
bool overlap(Course<Core>& course, const Watch& watch, double later)
{
    if (course.radii > 0) return false;
    const double now = course.now();
    course.go(later);
    const bool proven = watch.overlap(course.facing(), course.rounding);
    course.go(now);
    return proven;
}
bool overlap(const Course<Border>&, const BorderWatch&, double) { return false; }

template <class Part, class WatchOfPart>
double proven_contact(Course<Part>& course, const WatchOfPart& watch, const Sight& sight)
{
    const V3 n = sight.best_normal();
    const double closing =
        -trend(course.facing(), {n, sight.axis.spin}, sight.point_a, sight.point_a + sight.v).rate;
    const double gap = std::max(0.0, dot(sight.v, n) - course.radii);
    if (!(closing > 0)) return infinity;
    const auto by = [&](double deep) {
        return std::min(course.now() + 2 * (gap + deep) / closing, course.options.t_max);
    };
    const double soon = by(tolerance::shallow * course.rounding),
                 later = by(2 * course.tolerance + tolerance::deeper * course.rounding);
    if (in_contact(course, sight, soon)) return soon;
    if (in_contact(course, sight, later)) return later;
    if (overlap(course, watch, soon)) return soon;
    return overlap(course, watch, later) ? later : infinity;
}

} // namespace

Separation contact_at(const Course<Core>& course, Watch& watch, const Sight& sight)
{
    const Facing<Core>& f = course.facing();
    const double doubt = tolerance::shown * course.rounding;
    if (const auto s = shown(sight, f, doubt)) return *s;
    if (!is_polytope(f.a.part) || !is_polytope(f.b.part)) {
        const Sight close = watch.look_closely(f);
        if (const auto s = shown(close, f, std::max(doubt, tolerance::told * course.tolerance))) return *s;
    }
    return course.separated();
}
Separation contact_at(const Course<Border>& course, const BorderWatch&, const Sight&)
{
    return course.separated();
}

double contact_by(Course<Core>& course, const Watch& watch, const Sight& sight)
{
    return proven_contact(course, watch, sight);
}
double contact_by(Course<Border>& course, const BorderWatch& watch, const Sight& sight)
{
    return proven_contact(course, watch, sight);
}

} // namespace brink
