// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

} // namespace brink
