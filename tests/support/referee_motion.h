// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bracket.h"
#include "hundred.h"
#include "query.h"

#include <optional>

/// Two moving solids, as "What the doubles mean" of the design has it, in a frame whose origin moves with
/// body B's pivot and does not turn.
namespace brink::support {

template <class T> struct MovingBody {
    Solid<T> solid;
    Vector<T> pivot, velocity; // pivot(t) = pivot + t * velocity
    Vector<T> rotation;        // over the step
    T rate = 0;                // |rotation|
    Matrix<T> start;           // orientation at t = 0
    Vector<T> arm;             // the pivot in the local frame
    T reach = 0;               // no point of the core is farther from the pivot
    T swing = 0;               // nor from the axis through the pivot that it turns about
    T extent = 0;              // of the core from the local origin; of a border, its offset

    Placement<T> at(const T& t) const;
};

template <class T> class MovingPair {
public:
    /// A query that is judgeable().
    explicit MovingPair(const Query&);

    const MovingBody<T>& a() const { return a_; }
    const MovingBody<T>& b() const { return b_; }

    /// The gap at t. `enough` as in bracket().
    Bracket<T> at(const T& t, const Vector<T>& hint = Vector<T>{}) const;

    /// From the world to the frame of the placements.
    Vector<T> from_world(const Vec3& point, const T& t) const;

    const T& target() const { return target_; }
    /// S of design promise 3.
    const T& scale() const { return scale_; }
    /// No gap changes faster than this (length per step) over [0, 1].
    const T& fastest() const { return fastest_; }
    /// No two points of the cores part or meet faster than this (length per step).
    const T& rush() const { return rush_; }
    bool over_ground() const { return a_.solid.unbounded() || b_.solid.unbounded(); }
    bool turns() const { return a_.rate > 0 || b_.rate > 0; }

    /// For normals n0 at t0 and n1 at t1 = t0 + h: with n(t) linear in t between them (turning with the
    /// ground if there is ground) and any two points alpha of A, beta of B, f = n . (beta - alpha) has |f''|
    /// h^2 <= bulge(n0, n1, h). Hence the gap over [t0, t1] is at least the chord between its bounds at the
    /// ends less bulge x (1 - x) / 2, x = (t - t0) / h, where that is not negative (|n| <= 1).
    T bulge(const Vector<T>& n0, const Vector<T>& n1, const T& h) const;

    /// When the balls about the pivots that hold the bodies are within the target gap of each other: the gap
    /// is above it at other times. Empty if never; all of time where there is ground.
    struct Window {
        T from, to;
    };
    std::optional<Window> window() const;

    /// How near two bounds are asked to be: a length. What rounding may add to a bound of the gap.
    const T& enough() const { return enough_; }
    const T& blur() const { return blur_; }

private:
    MovingBody<T> a_, b_;
    Vector<T> origin_, drift_; // of the frame, in the world
    T target_, scale_, fastest_, rush_, bend_, enough_, blur_;
};

extern template struct MovingBody<long double>;
extern template struct MovingBody<Hundred>;
extern template class MovingPair<long double>;
extern template class MovingPair<Hundred>;

} // namespace brink::support
