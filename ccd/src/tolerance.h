// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Every tolerance of the time-of-impact code, with its unit and derivation.
namespace brink::tolerance {

/// Relative rounding error of one operation, 2^-53.
inline constexpr double unit_roundoff = 0x1p-53;

/// Where two cores come nearer than this times (relative position + relative motion), the vector between them
/// is mostly rounding: four roundings of each coordinate, a few times over. The contact feature gives the
/// normal.
inline constexpr double core_noise = 64 * unit_roundoff;

/// Rounding of a pose and of one separation along an axis, as a multiple of the sum of the lengths and arcs
/// that enter them: the operations counted in numerics.md.
inline constexpr double certificate_slack = 128 * unit_roundoff;

/// The same where the caller's tolerance has no room for the worst case: what is left when every rounding
/// goes the same way but each is of average size. It keeps promise 3 of a gap within 16 eps of the scale.
inline constexpr double least_slack = 5 * unit_roundoff;

/// The balls of the swept-sphere clip grow by this times (relative position + relative motion + radii): the
/// quadratic's discriminant and root are those of a ball and a path that differ by a few roundings of these.
inline constexpr double clip_slack = 64 * unit_roundoff;

/// Squared sine of the angle between two segments below which a place on one no longer fixes that on the
/// other: the rounding of their cross product, 2^-53, then moves it by 2^-43.
inline constexpr double nearly_parallel = 1e-6;

/// Relative error of a root whose terms are exact but for their conversion to double: 2 u each, halved by the
/// square root, and three operations.
inline constexpr double exact_root = 8 * unit_roundoff;

/// A ball that is to hold a shape grows by this part of its radius: many roundings of it.
inline constexpr double holding_slack = 0x1p-40;

/// How flat in a supporting plane an edge lies that may be touching (sine of the angle): a guess, which no
/// answer's validity rests on.
inline constexpr double flat_edge = 1e-3;

/// The part of the time left below which a step is no step: more axes are tried, and nothing rests on it.
inline constexpr double standstill = 1e-9;

/// What Motion::at may be off by, as documented with it, four times over (of the lengths and arcs of the
/// motion).
inline constexpr double pose_rounding = 0x1p-46;

/// A bound moved outwards by this part of itself has outrun the few roundings of its sums.
inline constexpr double outwards = 0x1p-50;

/// A step shortened by this factor has outrun the rounding of its own root.
inline constexpr double step_shrink = 1 - 0x1p-51;

/// A difference of squares below this part of them has lost four bits or more to cancellation: it is taken
/// again with the rounding errors of its terms. Above, it is right to 16 times a few roundings.
inline constexpr double cancelled = 1.0 / 16;

/// Larger sums of positions, motions and sizes would overflow when multiplied four at a time (scene length
/// unit).
inline constexpr double largest_extent = 1e75;

} // namespace brink::tolerance
