// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "stress.h"

/// As stress.h, for every pair, with bodies that turn: queries hard in one way each, at a known degree.
namespace brink::support {

enum class TurningStress : unsigned char {
    angle,     // by how much they turn, from nothing to 100 turns
    rocking,   // A stands next to B and rocks on the point that is nearest
    pivot,     // they turn about a point far off the body
    needle,    // one or both are long and thin
    origin,    // both off the origin by a common offset
    far,       // they start far apart
    scale,     // every length times s, the tolerance too
    grazing,   // the closest approach differs from contact by little, to either side
    touching,  // the gap at the start is almost nothing, to either side, or exactly nothing
    tolerance, // how near counts as contact
};

/// How a class's degree of difficulty, the level, is to be read: a power of ten in [first, last).
struct TurningClass {
    TurningStress stress;
    std::string_view name;     // on a command line
    std::string_view quantity; // what 10^level is
    double first, last;
    double decades; // that one step of a picture's axis covers
};

/// "angle" and "touching" begin with a step for what is exactly zero.
inline constexpr std::array<TurningClass, 10> turning_classes{{
    {TurningStress::angle, "angle", "angle, radians (628: 100 turns)", -13, 3, 1},
    {TurningStress::rocking, "rocking", "angle, radians (628: 100 turns)", -12, 3, 1},
    {TurningStress::pivot, "pivot", "pivot's distance / size", 0, 9, 1},
    {TurningStress::needle, "needle", "length / thickness", 0, 6, 1},
    {TurningStress::origin, "origin", "common offset / size", 0, 12, 1},
    {TurningStress::far, "far", "distance / size", 0, 8, 1},
    {TurningStress::scale, "scale", "size", -100, 100, 20},
    {TurningStress::grazing, "grazing", "|closest gap| / size, as aimed", -15, -2, 1},
    {TurningStress::touching, "touching", "|gap at the start| / size", -17, -3, 1},
    {TurningStress::tolerance, "tolerance", "tolerance / size", -15, -1, 1},
}};

inline const TurningClass& described(TurningStress stress)
{
    return turning_classes[static_cast<std::size_t>(stress)];
}

/// A function of its arguments alone. At most one of the pair is unbounded. Between a quarter and nine tenths
/// of the cases of a class have contact within the step.
StressCase stress(const Pair&, TurningStress, std::uint64_t seed, std::uint64_t index);

} // namespace brink::support
