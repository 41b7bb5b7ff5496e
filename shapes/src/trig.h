// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lanes.h"

namespace brink {

struct SinCos {
    double sin = 0, cos = 1;
};

/// Sine and cosine of an angle in radians, |angle| <= 2^20, each within one ulp. The C library's are not used
/// because their bits change with the machine.
SinCos sin_cos(double angle);

/// The same of two angles in little more time than of one: the same bits.
struct TwoSinCos {
    SinCos first, second;
};
TwoSinCos sin_cos(double first, double second);

/// The angle in [0, pi] of the direction (cos, sin). sin >= 0; sin^2 + cos^2 = 1 within a few ulp. Within 2
/// ulp.
double angle_of(SinCos);

/// pi/2 as a sum of doubles. The first three keep 33 bits, so that their products with a count of quarter
/// turns (below 2^20) are exact (Cody and Waite 1980); what is left out is below 2^-157.
inline constexpr double half_pi[] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2ep-69,
                                     0x1.b839a252049c1p-104};
inline constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
inline constexpr double to_whole = 0x1.8p52; // added, it leaves the nearest whole number in the last bits

/// Sines and cosines of two angles to within 3e-16: for guesses, which wait for nothing so long. |angle| <=
/// 2^20.
struct NearSinCos {
    Two sin{}, cos{1, 1};
};
static inline NearSinCos near_sin_cos(Two angles)
{
    // Quarter turns are counted in the last bits and taken off in three parts of pi/2.
    const Two counted = angles * both(two_over_pi) + both(to_whole), turns = counted - both(to_whole);
    const Two x = ((angles - turns * both(half_pi[0])) - turns * both(half_pi[1])) - turns * both(half_pi[2]);
    // The Taylor series, in pairs as in sin_cos().
    const Two s = x * x, s2 = s * s, s4 = s2 * s2;
    const auto two = [s](double first, double second) { return both(first) + s * both(second); };
    const Two of_sine = (two(-1.0 / 6, 1.0 / 120) + s2 * two(-1.0 / 5040, 1.0 / 362880)) +
                        s4 * (two(-1.0 / 39916800, 1.0 / 6227020800) + s2 * both(-1.0 / 1307674368000));
    const Two of_cosine = (two(1.0 / 24, -1.0 / 720) + s2 * two(1.0 / 40320, -1.0 / 3628800)) +
                          s4 * (two(1.0 / 479001600, -1.0 / 87178291200) + s2 * both(1.0 / 20922789888000));
    // After an odd quarter sine and cosine change places; the sine is negative after two and three, the
    // cosine after one and two.
    using Bits = unsigned long long __attribute__((vector_size(16)));
    const Bits quarter = reinterpret_cast<Bits>(counted), sine = reinterpret_cast<Bits>(x + x * s * of_sine);
    const Bits cosine = reinterpret_cast<Bits>((both(1) - both(0.5) * s) + s2 * of_cosine);
    const Bits change = (sine ^ cosine) & (Bits{} - (quarter & 1));
    const auto sign = [](Bits quarters) { return (quarters >> 1) << 63; };
    return {reinterpret_cast<Two>(sine ^ change ^ sign(quarter)),
            reinterpret_cast<Two>(cosine ^ change ^ sign(quarter + 1))};
}

} // namespace brink
