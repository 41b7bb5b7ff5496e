// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Every tolerance of the time-of-impact code, with its unit and derivation.
namespace brink::tolerance {

/// Relative rounding error of one operation, 2^-53.
inline constexpr double unit_roundoff = 0x1p-53;

/// Where two cores come nearer than this times (relative position + relative motion), what promise 3 allows a
/// point to be off, the vector between them may be all rounding, and the axis of the proof gives the normal.
/// Farther apart that axis, found from where a guess ended, is the worse of the two.
inline constexpr double core_noise = 32 * unit_roundoff;

/// The same part for two points, which have no feature: below it the vector between them is all rounding, and
/// the motion gives the normal.
inline constexpr double point_noise = 64 * unit_roundoff;

/// Rounding of a pose and of one separation along an axis, as a multiple of the sum of the lengths and arcs
/// that enter them: the operations counted in numerics.md.
inline constexpr double certificate_slack = 128 * unit_roundoff;

/// The same where the caller's tolerance has no room for the worst case: what is left when every rounding
/// goes the same way but each is of average size. It keeps promise 3 of a gap within 16 eps of the scale.
inline constexpr double least_slack = 5 * unit_roundoff;

/// Gaps that are told to be this part of the lengths of promise 3 count as there where nothing more is
/// proven: three quarters of what it allows, which leaves the rest to their own rounding.
inline constexpr double promised = 24 * unit_roundoff;

/// The balls of the swept-sphere clip grow by this times (relative position + relative motion + radii): the
/// quadratic's discriminant and root are those of a ball and a path that differ by a few roundings of these.
inline constexpr double clip_slack = 64 * unit_roundoff;

/// What such balls grow by, of the same lengths, where they are told before anything is turned: many times
/// all roundings of section 3.
inline constexpr double clip_room = 0x1p-40;

/// Squared sine of the angle between two segments below which a place on one no longer fixes that on the
/// other: the rounding of their cross product, 2^-53, then moves it by 2^-43.
inline constexpr double nearly_parallel = 1e-6;

/// Rounding of a point's height over a supporting plane, as a multiple of relative position + relative motion
/// + radii, and of the extents of points that a rotation has turned: the operations counted in numerics.md.
inline constexpr double axis_slack = 10 * unit_roundoff;
inline constexpr double turning_slack = 32 * unit_roundoff;

/// Rounding of a height from unevaluated pairs, as a multiple of all lengths that enter it: some twenty
/// operations of 4 u^2 each.
inline constexpr double pair_slack = 128 * unit_roundoff * unit_roundoff;

/// Relative error of a quotient of two numbers rounded from pairs, and of moving it by that: four roundings.
inline constexpr double quotient = 5 * unit_roundoff;

/// Where the turned extents make the slack larger than this part of all lengths, the time is proven again
/// from pairs: promise 3 allows 32 u, and the roundings themselves may add what the slack has to spare.
inline constexpr double strained = 20 * unit_roundoff;

/// A bracket wider than this part of its end is worth unevaluated pairs, which cost as much as all the rest:
/// a guess at what is, and nothing rests on it.
inline constexpr double blur = 0x1p-42;

/// How far off first contact a kernel's guess can be, as a multiple of the same lengths: a miss is believed
/// when there is no contact with the radius that much larger (numerics.md).
inline constexpr double guess_slack = 64 * unit_roundoff;

/// The same for separating axes over time, whose numbers pass through both rotations: of a height along a
/// cross product of unit axes, and what is left holds contact of boxes with rounded axes to be contact.
inline constexpr double slab_slack = 160 * unit_roundoff;

/// A radius below this part of all lengths is thin: what the guess of contact is off by turns an axis from
/// edge to edge too far for it to be proven.
inline constexpr double thin = 0x1p-20;

/// A face that a path leaves at less than this sine may, by rounding, be one that it nears.
inline constexpr double edge_on = 0x1p-40;

/// Contact along an axis is sure this many slacks below where the height has fallen to the radius: the axis
/// itself may be off by one and the corners by another.
inline constexpr double overlap_depth = 4;

/// A witness of contact is looked for this many slacks below where the height must have fallen to the radius:
/// one for that to be certain, two for the witness itself.
inline constexpr double witness_depth = 3;

/// An axis is good enough when it leaves a gap of at most this many slacks: its own, and the rounding of the
/// gap.
inline constexpr double loose_axis = 2;

/// Relative error of a root whose terms are exact but for their conversion to double, 2 u each: 2 u for
/// c, 4.5 u for the product of two square roots, and three operations.
inline constexpr double exact_root = 10 * unit_roundoff;

/// Its bracket, up to 20 places wide, is halved this often: to three places.
inline constexpr int halvings = 3;

/// A ball that is to hold a shape grows by this part of its radius: many roundings of it.
inline constexpr double holding_slack = 0x1p-40;

/// Rounding of the rate of a gap under translation, as a part of the speed: a few roundings of the normal,
/// and three of the product.
inline constexpr double rate_slack = 32 * unit_roundoff;

/// Where the curvature of a bound takes more than this part of the gap over the whole horizon, a sharper one
/// is worth two more support points: a guess, on which no answer's validity rests.
inline constexpr double much_curved = 0.02;
/// So many times as far as a bound is seen to fall its sharper form may hold: a guess, too.
inline constexpr double beyond_fall = 1.3;

/// Bounds of a gap that come this near, as a part of its rounding, show a contact as well as any (8 eps of
/// the lengths): the same that distance() asks of itself.
inline constexpr double shown = 0.125;

/// On the way to contact the distance of curved surfaces is looked at to this part of what it exceeds contact
/// by: a step is that much shorter than it could be.
inline constexpr double near_enough = 1e-4;

/// The same of the first look at polytopes, which is to tell whether they can meet at all and about where.
inline constexpr double from_afar = 0.125;

/// How near the bounds of a gap of curved surfaces must come in an answer, as a part of the tolerance.
inline constexpr double told = 0x1p-6;

/// When features followed are looked at again (parts of a gap; guesses, on which no answer's validity rests):
/// when a step leaves more than this of the gap, where it should leave its square;
inline constexpr double slow_step = 0.5;
/// when the gap has shrunk to this since the last look, their own distance is taken,
inline constexpr double worth_landing = 0.1;
/// and the axis must prove this much of it.
inline constexpr double stale_features = 0.5;
/// when they led to no leap and the bodies have turned by this since (radians, of both together).
inline constexpr double far_turned = 0.4;

/// After so many looks the features that were seen do not tell how the axis turns: likewise a guess.
inline constexpr int quick_way = 8;

/// So often is a time of contact guessed before it is left alone, and up to so many looks: likewise guesses.
inline constexpr int most_guesses = 8;
inline constexpr int most_leaps = 2;

/// After so many looks a point's way past a core is left to the general advancement: likewise a guess.
inline constexpr int most_passing = 24;

/// After so many looks the way is a long one, on which axes at hand are tried before the next: likewise a
/// guess, as is the part of a step that is worth its while.
inline constexpr int long_way = 32;
inline constexpr double worth_coasting = 0.1;
inline constexpr int most_coasted = 64; // steps to a look

inline constexpr int most_strides = 2048; // in all

/// A whole turn, and a little more. On a long way bodies that come back to where they were are watched over
/// one, if what they drift until the end is less than this part of the gap.
inline constexpr double whole_turn = 6.2831853071796 + 1e-10;
inline constexpr double spared = 0.25;

/// Up to so many corners are looked at one by one on such a way.
inline constexpr int most_corners = 1024;

/// So many axes are tried for a stride, tilted by up to the tangent of the angle. Likewise guesses.
inline constexpr int most_tilts = 16;
inline constexpr double widest_tilt = 2;
inline constexpr int idle_tilts = 5;    // of polytopes, one after the other that lead no farther than
inline constexpr double farther = 1.25; // times the longest so far

/// Sine of the angle between two edges above which the axis across both is followed (a guess), and the
/// rounding of heights along it, as a part of all lengths over that sine: products of three vectors, 12 u,
/// and the points that they start from, 4 u.
inline constexpr double skew = 1e-3;
inline constexpr double edge_slack = 16 * unit_roundoff;

/// The largest product of a vector in a plane with eight directions around it, times this, is no less than
/// its length: 1 / cos(22.5 degrees), rounded up by far more than a few roundings.
inline constexpr double ring_excess = 1.0824;

/// How much of the time in which a deep contact could end is passed before it is looked at again.
inline constexpr double watchful = 0.25;

/// How much of a budget may go into the way out of a contact that must not deepen before that is `touching`.
inline constexpr double most_watched = 0.5;

/// How deep in roundings a time is tried at which contact is to be proven: first as little as may show, then
/// enough for features that slip.
inline constexpr double shallow = 8;
inline constexpr double deeper = 64;

/// An axis that turned by less (radians) does not tell how fast it turns: normals of curved surfaces are no
/// better known. Likewise a guess.
inline constexpr double least_turn = 1e-7;

/// Axis steps without an evaluation of the distance, one after the other: likewise a guess.
inline constexpr int most_followed = 12;

/// How flat in a supporting plane an edge lies that may be touching (sine of the angle): a guess, which no
/// answer's validity rests on.
inline constexpr double flat_edge = 1e-3;

/// A part of the time left that is worth a step even where it takes nothing beyond the tolerance.
inline constexpr double small_part = 0x1p-10;

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

/// What that leaves in doubt, as a part of the squares: their errors' errors, 2^-106, some forty of them, and
/// enough over for the root to be right to a factor of two.
inline constexpr double cancelled_slack = 0x1p-90;

/// Balls that differ by this part of (relative position + radius) in radius tell whether rounding can decide
/// if a path meets them: four roundings of each component of a cross product, and the position's own.
inline constexpr double ring = 10 * unit_roundoff;

/// Rounding of the squared distance at the end of the step, as a part of the square of all lengths in it:
/// eight roundings of a square, sixteen of a product of two different ones.
inline constexpr double end_slack = 16 * unit_roundoff;

/// What products of lengths near 2^-60 or smaller may lose to the end of the range of doubles.
inline constexpr double nothing = 0x1p-900;

/// A face with a normal shorter than this lies all within rounding of its edges, and its own products
/// underflow.
inline constexpr double smallest_normal = 0x1p-400;

/// Error of |p|^2 - R^2 from exact products, as a multiple of R times the lengths that enter p.
inline constexpr double polish_slack = 32 * unit_roundoff * unit_roundoff;

/// Relative rounding of a Newton step: of the point, 2 u, and of the dot product that says how fast it nears
/// the sphere, 3 u of what it is head-on; a few more.
inline constexpr double rounded_step = 16 * unit_roundoff;

/// A Newton step is short when the parabola's bend changes it by less than this part; the true one is then
/// longer by less than its bend.
inline constexpr double largest_bend = 0.25;

/// A root known to this part of itself is sharp; otherwise exact numbers are asked.
inline constexpr double sharp_root = 4 * unit_roundoff;

/// Lengths are scaled by a power of two unless their sum lies between these: products of eight then stay far
/// from both ends of the range of doubles.
inline constexpr double smallest_lengths = 0x1p-60;
inline constexpr double largest_lengths = 0x1p60;

/// Positions that scaling would bring beyond this are not scaled; they leave differences of zero or far
/// larger than what they would be scaled for.
inline constexpr double largest_position = 0x1p1000;

/// What a scene's bounds of one body grow by, of the lengths and arcs that enter them: eight times the band
/// of promise 3 (32 u of the lengths of both), which leaves room for the rounding of the bounds themselves.
inline constexpr double sweep_slack = 256 * unit_roundoff;

/// Beyond such lengths bounds are all of space, so that nothing overflows a float.
inline constexpr double largest_culled = 0x1p120;

/// A float that is to lie outside of what it stands for: the conversion to nearest and the two operations
/// that move it are each off by 2^-24 of it.
inline constexpr float float_outwards = 0x1p-22F;

/// Rounding errors of coordinates, added up as doubles, bound the distance by which a point is off.
inline constexpr double float_sums = 1 + 0x1p-20;

/// Balls in floats grow by this part of (relative position + relative motion): 2^-24 for each of the dozen
/// operations between the coordinates and the squared distance, and for the root of it.
inline constexpr float ball_slack = 0x1p-19F;

/// A float's time of contact is rounded down by this part of itself: that of a dozen operations.
inline constexpr float time_slack = 0x1p-18F;

/// A ball passes a plane when it is farther than this part of all lengths, many times the rounding of
/// doubles.
inline constexpr double border_room = 0x1p-40;

/// Squares of lengths below this have lost digits to underflow.
inline constexpr float smallest_square = 0x1p-100F;

/// Squares of sums of lengths up to this are floats, and so are sums of a few of them.
inline constexpr float largest_squared = 0x1p62F;

/// Cross products of a swept segment in floats are off by less than this part of the products they are
/// differences of: 2^-24 for each of five operations.
inline constexpr float segment_slack = 0x1p-20F;

} // namespace brink::tolerance
