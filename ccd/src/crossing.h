// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "approach.h"
#include "lanes.h"
#include "tolerance.h"

/// From a guess at the touching feature to a time that is proven: a point that moves against a polytope grown
/// by a radius. Proofs in numerics.md, "Closed forms".
namespace brink {

/// How near counts as contact, and what rounding may take from or add to a length.
struct Reach {
    double radius;
    double slack;   // of a height along a given axis, per length of the axis
    double margin;  // of first contact as the kernels guess it: they look for contact within radius + margin
    bool strained;  // whether slack is most of what promise 3 allows a gap at t to be
    double lengths; // relative position + relative motion + radius
};

/// `extents`: how far the turned points of both shapes lie from their origins.
static inline Reach reach(const Approach& m, double radius, double extents)
{
    const Two path = square_root(Two{norm_squared(m.from), norm_squared(m.by)});
    const double lengths = path[0] + path[1] + radius, all = lengths + extents;
    const double slack = tolerance::axis_slack * lengths + tolerance::turning_slack * extents;
    return {radius, slack, tolerance::guess_slack * all, slack > tolerance::strained * all, lengths};
}

static inline double squared(double x) { return x * x; }

/// When the height along an axis falls to what is proven to be above the reach, and to what is proven to be
/// below it. The height is that of the point over the polytope's supporting plane, above the reach at t = 0.
struct Crossing {
    double t, t_upper;
    bool closing;

    bool blurred() const { return t_upper - t > tolerance::blur * t_upper; }
};
static inline Crossing crossing(double above, double rate, double slack,
                                double depth = tolerance::witness_depth)
{
    return {(above - slack) / rate, (above + depth * slack) / rate, rate > 0 && above > slack};
}

/// The entry along `axis`, given the point's least height over the polytope along it at t = 0. `nearest`
/// gives a point of the polytope near the one it is given. `early`: a time before which the guess has proven
/// the shapes apart. `later` proves a later time along an axis, for where the approach is slow.
template <class Nearest, class Later>
[[gnu::always_inline]] inline Entry proven(const Approach& m, const Reach& r, V3 axis, double height,
                                           double early, Nearest nearest, Later later)
{
    const double length = norm(axis), slack = r.slack * length;
    Crossing c = crossing(height - r.radius * length, -dot(axis, m.by), slack);
    if (!c.closing) return {.t = early};
    if (c.blurred() || r.strained) c.t = later(axis, c.t);
    if (c.t > m.t_max) return {.found = Found::apart};
    const V3 at = m.from + c.t * m.by, met = nearest(at);
    // A guess that is off leaves a gap behind.
    if (!(norm_squared(at - met) <= squared(r.radius + tolerance::loose_axis * r.slack))) return {.t = early};
    const V3 deep = m.from + c.t_upper * m.by;
    const double inner = r.radius - r.slack;
    if (!(inner > 0 && norm_squared(deep - nearest(deep)) <= squared(inner))) return {.t = early};
    return {c.t_upper > m.t_max ? Found::doubt : Found::hit, c.t, c.t_upper, Meeting{at, met, -axis, false}};
}

/// The same to the end of the step, and what it found cut at t_max: for pairs whose doubts go to the
/// advancement, which must not come out otherwise for another t_max. Contact not proven by t_max is told too.
static inline Approach whole_step(const Approach& m)
{
    return {m.from, m.by, m.target_gap, 1, m.motion_a, m.motion_b};
}
static inline Entry cut(Entry e, double t_max)
{
    if (e.found != Found::hit) return e;
    if (e.t > t_max) return {.found = Found::apart};
    if (e.t_upper > t_max) e.t_upper = infinity;
    return e;
}

/// The same against a flat face: the point proven to enter the slab of the radius between the face's sides.
/// `inside` says whether a point of the plane lies inside the face by more than a margin.
template <class Inside, class Later>
[[gnu::always_inline]] inline Entry proven_on_face(const Approach& m, const Reach& r, V3 normal,
                                                   double height, double early, Inside inside, Later later)
{
    const double length = norm(normal), slack = r.slack * length, rate = -dot(normal, m.by);
    const double above = height - r.radius * length;
    Crossing c = crossing(above, rate, slack);
    if (!c.closing) return {.t = early};
    if (c.blurred() || r.strained) c.t = later(normal, c.t);
    if (c.t > m.t_max) return {.found = Found::apart};
    const V3 at = m.from + c.t * m.by;
    const V3 foot = at - ((height - c.t * rate) / (length * length)) * normal;
    if (!inside(foot, 8 * r.slack + (c.t_upper - c.t) * norm(m.by))) return {.t = early};
    const Found found = c.t_upper > m.t_max ? Found::doubt : Found::hit;
    return {found, c.t, c.t_upper, Meeting{at, foot, -normal, true}};
}

} // namespace brink
