// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/motion.h>
#include <brink/status.h>

#include <limits>

namespace brink {

/// What to do with a pair that is in contact when the step begins (gap <= target_gap at t = 0). While it
/// leaves that contact, until the gap exceeds target_gap by more than the tolerance, a return no deeper than
/// the tolerance may be passed over.
enum class StartContact : unsigned char {
    report,               // say `touching`
    ignore_if_separating, // if the gap is proven not to decrease, look for the next contact; else `touching`.
                          // Of bodies that turn and overlap by more than the tolerance, a fall by less than a
                          // quarter of the overlap and back may go unseen
    ignore,               // look for the next contact, after the gap has first exceeded target_gap
};

enum class Detail : unsigned char {
    contact,   // everything
    time_only, // normal, points and gap are not computed
};

struct Options {
    double t_max = 1;        // look no further; in [0, 1]
    double target_gap = 0;   // count as contact when the shapes come this near (minimum separation); >= 0
    double tolerance = 1e-9; // length unit, >= 0: how near counts as there, where no closed form decides
    StartContact start_contact = StartContact::report;
    Detail detail = Detail::contact;
    int max_iterations = 256; // distance evaluations; at least 1
};

/// When two moving shapes first touch. Whatever the status, the shapes are apart before t: a caller that
/// moves both bodies to t cannot tunnel.
struct Toi {
    /// invalid: t = 0. separated: no contact in [0, t_max], t = t_max. touching: contact at t = 0.
    /// hit: first contact in [t, t_upper]. undecided: proven apart before t, nothing known after it.
    Status status = Status::invalid;
    double t = 0;
    double t_upper = infinity; // contact is proven to have begun by then; infinite where that is not proven
    /// At t, for touching, hit and undecided; a pair that is separated has none of the following. Up to
    /// rounding; where a cylinder, cone or ellipsoid takes part, gap and points to a 32nd of the tolerance,
    /// or gap to 2^-30 and points to 2^-20 of all lengths.
    Vec3 normal{0, 0, 0};  // unit, world, from A towards B; zero only where none is defined
    Vec3 point_a{0, 0, 0}; // on A, world
    Vec3 point_b{0, 0, 0}; // on B, world: point_b - point_a = gap * normal
    double gap = std::numeric_limits<double>::quiet_NaN(); // signed distance; scene length unit
    int iterations = 0;                                    // distance evaluations spent; 0 for a closed form
};

/// First time in [0, t_max] at which the gap between the two moving shapes is at most target_gap.
///
/// Where only translation matters and the pair is `exact` (README, "Pairs"), hit or miss is the exact
/// answer for the doubles given, whatever their magnitude, and t_upper is finite; a hit with an infinite
/// t_upper says that even exact arithmetic could not hold the numbers (quaternion components that differ by
/// 1e100 or more). All other decisions are certified: what rounding leaves in doubt is a hit within the
/// tolerance, or undecided. Where a cylinder, cone or ellipsoid takes part and the tolerance is below 1e-11
/// of all lengths, contact itself may be undecided. Never throws, allocates or prints; what is not a number
/// or out of range is answered `invalid`.
Toi time_of_impact(const Shape& a, const Motion& motion_a, const Shape& b, const Motion& motion_b,
                   const Options& options = {});

} // namespace brink
