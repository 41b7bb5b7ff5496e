// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query.h"
#include "reference_gap.h"

namespace brink::support {

/// The gap of a query's shapes over time, in long double, about the start of body B so that a common offset
/// costs nothing. Both shapes must be valid and at most one of them unbounded. Of a cylinder, cone, ellipsoid
/// or hull that overlaps another no depth is known, and what is near is known to fewer digits: enough to aim
/// by.
class GapOverTime {
public:
    explicit GapOverTime(const Query&);

    Gap at(Real t) const;

    /// B's placed shape and A's at t: for points given in the world, subtract origin() first.
    Placed placed_a(Real t) const { return place(shape_a_, a_.at(t)); }
    Placed placed_b(Real t) const { return place(shape_b_, b_.at(t)); }
    Real3 origin() const { return origin_; }

    /// Whether neither body turns: then the gap is a convex function of time.
    bool translates() const { return a_.turn == 0 && b_.turn == 0; }

    /// No gap changes faster than this (length per step).
    Real fastest() const { return fastest_; }

    /// S of design promise 3.
    Real scale() const { return scale_; }

    /// A time tau > 0, at most `most`, such that the gap stays above `level` over [t, t + tau], given the gap
    /// there.
    Real safe_step(Real t, const Gap& here, Real level, Real most) const;

private:
    struct Body {
        Real3 pivot, translation, axis; // axis: unit; angle `turn` over the step
        Real3 pivot_local;
        Real33 orientation;
        Real turn = 0;
        Real reach = 0; // farthest core point from the pivot
        RealPose at(Real t) const;
        Real3 velocity(Real t, const Real3& point) const;
    };
    static Body body(const Shape&, const Motion&, const Real3& origin);

    /// Where the points of a core are along the normal, from point_a of the gap, and how fast they move along
    /// it: at the point p, base + p . normal and rate + p . turning.
    struct Line {
        Placed core;
        Real3 normal, turning;
        Real base = 0, rate = 0;
        /// The least of base + tau * rate over the core.
        Real least(Real tau) const;
    };
    enum class Side : unsigned char { a, b };
    Line line(Real t, const Gap& here, Side side) const;

    Shape shape_a_, shape_b_;
    Real3 origin_;
    Body a_, b_;
    Real fastest_ = 0, bend_ = 0, scale_ = 0;
};

/// What the reference knows of a query.
struct Reference {
    bool contact = false; // within `blur` of the target gap at t
    Real t = 0;           // first contact; t_max without one
    Real start_gap = 0;
    Real least_gap = 0;     // over the part of [0, t_max] in question; exact where it is near target_gap
    Real closing_speed = 0; // at contact, length per step
    bool grazing = false;   // closing speed below 1e-3 of the fastest relative motion
    bool started = false;   // gap(0) <= target_gap
    Real drop = 0; // with start contact: by how much the gap decreased before it first exceeded the target
    bool left = false;    // with start contact: whether the gap ever exceeded the target
    bool gave_up = false; // out of evaluations: apart before t, nothing known after
    int evaluations = 0;
};

/// How near counts as contact for the reference itself: its own rounding.
Real blur(const GapOverTime&);

/// First contact: by bisection of the convex gap for pure translation, else by safe steps that cannot pass a
/// root. Contact at the start is treated as the options say; an excursion above the target shorter than 1e-5
/// of the step counts as none.
Reference reference(const Query&, const GapOverTime&);

/// The same by safe steps whatever the motion, from time `from` on: the two hold each other.
Reference reference_walk(const Query&, const GapOverTime&, Real from);

} // namespace brink::support
