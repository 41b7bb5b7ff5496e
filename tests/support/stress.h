// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query.h"

/// Queries that are hard in one way each, at a known degree: what the stability measurements and tests ask.
/// Both bodies only translate, and shapes measure about 1 unless the class says otherwise.
namespace brink::support {

enum class Stress : unsigned char {
    random,           // no difficulty: the measure for the others
    scale,            // every length times s
    origin,           // both bodies off the origin by a common offset
    far,              // they start far apart
    size_ratio,       // one body larger than the other; than the approach where the other is ground
    grazing,          // the closest approach differs from contact by little, to either side
    parallel,         // edges, faces or the motion almost parallel, or exactly so
    equal_velocities, // the motion of both is much larger than their relative motion
    touching,         // the gap at the start is almost nothing, to either side, or exactly nothing
    t_max,            // contact within 4e-16, relatively, of t_max
};

/// How a class's degree of difficulty, the level, is to be read: a power of ten in [first, last).
struct StressClass {
    Stress stress;
    std::string_view name;     // on a command line
    std::string_view quantity; // what 10^level is
    double first, last;
    double decades; // that one step of a picture's axis covers
};

inline constexpr std::array<StressClass, 10> stress_classes{{
    {Stress::random, "random", "distance / size", 0, 1, 1},
    {Stress::scale, "scale", "size", -150, 150, 20},
    {Stress::origin, "origin", "common offset / size", 0, 12, 1},
    {Stress::far, "far", "distance / size", 0, 8, 1},
    {Stress::size_ratio, "size_ratio", "size of A / size of B", -8, 8, 1},
    {Stress::grazing, "grazing", "|closest gap| / size", -16, -2, 1},
    {Stress::parallel, "parallel", "angle, radians", -15, -1, 1},
    {Stress::equal_velocities, "equal_velocities", "relative motion / motion", -12, 0, 1},
    {Stress::touching, "touching", "|gap at the start| / size", -17, -3, 1},
    {Stress::t_max, "t_max", "t_max", -6, 1, 1},
}};

inline const StressClass& described(Stress stress)
{
    return stress_classes[static_cast<std::size_t>(stress)];
}

/// Empty for a name that is none of stress_classes.
std::optional<Stress> stress_named(std::string_view name);

struct StressCase {
    Query query;
    /// Decimal logarithm of the class's quantity; the class's first where angle or gap is zero, exactly.
    double level = 0;
};

/// A function of its arguments alone. The pair must have a closed form. About half of the cases of a class
/// have contact within t_max.
StressCase stress(const Pair&, Stress, std::uint64_t seed, std::uint64_t index);

} // namespace brink::support
