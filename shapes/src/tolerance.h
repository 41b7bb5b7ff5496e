// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

/// Every tolerance of the shapes half, with its unit and where it comes from.
namespace brink::tolerance {

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// How far the squared length of a normal or quaternion may be from 1 (no unit): a unit vector rounded to
/// single precision is off by at most 3 * 2^-24 per component, 4e-7 in the square.
inline constexpr double unit = 1e-6;

/// A distance is certain when its upper and lower bounds differ by at most this times the scale (no unit; the
/// scale is the largest coordinate): two support values of three products each and the difference of the
/// witness points come to some 16 roundings (of epsilon / 2).
inline constexpr double tight = 8 * epsilon;

/// How far a coordinate of a turned vector may be off, times the sum of the vector's coordinates without sign
/// (no unit): 17 roundings (of epsilon / 2) in an entry of the rotation, 3 in the product, doubled for
/// safety.
inline constexpr double turned = 20 * epsilon;

/// Bounds of a distance that differ by this many times the slack are not worth the long way (no unit): 512
/// roundings, and still a thousandth of the default tolerance of a query in a scene of size 10.
inline constexpr double agreed = 64;

/// Round cores of which points are known that are no farther from each other than the square root of this
/// times the slack count as touching, and their supporting planes tell how far apart they are (no unit):
/// chords of 2^-19 of the scale leave a surface curved like the scale by 2^-41 of it.
inline constexpr double contact = 0x1p60;

/// Two edges count as parallel when the sine of their angle is at most this (no unit): the rounding of the
/// cross product of two unit vectors. Treating them as parallel moves an end by no more than that.
inline constexpr double parallel = 8 * epsilon;

/// Scales outside of these are first multiplied by a power of two (scene length unit): products of five
/// lengths stay within the normal range of a double.
inline constexpr double least_scale = 0x1p-200;
inline constexpr double largest_scale = 0x1p200;

/// Outside of these a squared length may have lost digits or overflowed (squared length unit).
inline constexpr double least_square = 0x1p-960;
inline constexpr double largest_square = 0x1p960;

/// By how much a determinant of differences of coordinates may be off, times the sum of its terms without
/// signs (no unit): seven roundings (of epsilon / 2; J. Shewchuk 1997), doubled for safety.
inline constexpr double side = 8 * epsilon;

/// The same, whatever the terms, where coordinates are at most 2 and the normal is a cross product of two
/// differences (volume unit): nine products of up to 64, four roundings each, some 2^9 epsilon, doubled.
inline constexpr double plane = 0x1p-40;

/// By how much the plane of two edges may be off within the hull, times the lengths of both and over that of
/// their cross product (no unit, coordinates below 2): 6 roundings (of epsilon / 2) of each of its
/// components, over a distance of 7, doubled twice.
inline constexpr double face = 0x1p-45;

/// A ball that touches a plane at its computed distance is surely on the near side of it when the square of
/// its radius is multiplied by this (no unit).
inline constexpr double inner = 1 - 0x1p-20;

} // namespace brink::tolerance
