// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query.h"
#include "random.h"
#include "reference.h"

#include <functional>

/// How a query is aimed: what the generators of nasty queries share.
namespace brink::support {

/// A plane or half-space.
bool unbounded(const Shape&);

/// Where A starts relative to B, and how it moves relative to B.
struct Path {
    Vec3 from, by;
};

/// Ground reaches everywhere: lifts A's start off it, mostly, and mostly on the side its normal points to.
Path above_ground(Random&, Path, const Shape& ground, const Quat& orientation);

/// The gap at a time: in long double, or in doubles, to their rounding and with no depth of cores that
/// overlap, in a fraction of the time.
using GapAt = std::function<Real(Real)>;
GapAt gap_at(const Query&, Aim);

/// The least gap within [0, t_max], by so many steps of golden section: a local one where the motion turns.
Real least_gap(const GapAt&, double t_max, int steps = 48);
Real least_gap(const GapOverTime&, double t_max, int steps = 48);

/// How often the gap is looked at over all of the time, and how often the place of the least is made finer.
struct Looks {
    int all_over = 0, rounds = 0;
};
/// The least gap within [0, t_max] of bodies that may turn: of so many looks, then of finer ones about the
/// least of them.
Real least_gap_seen(const GapAt&, double t_max, Looks);
Real least_gap_seen(const GapOverTime&, double t_max, Looks);

/// Moves the target gap, or a radius, so that `measured` ends `beyond` above the target gap.
Query tuned(Query, Real measured, double beyond);

} // namespace brink::support
