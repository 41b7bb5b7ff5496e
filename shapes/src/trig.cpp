// SPDX-License-Identifier: BSD-3-Clause
#include "trig.h"

#include "exact.h"
#include "lanes.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace brink {

namespace {

struct Reduced {
    Pair angle;  // at most pi/4 (a little more by rounding), to 2^-100
    int quarter; // quarter turns taken off, 0 to 3
};

Reduced reduce(double angle)
{
    if (std::fabs(angle) * two_over_pi < 0.5) return {{angle, 0}, 0};
    const double shifted = angle * two_over_pi + to_whole, turns = shifted - to_whole;
    const double first =
        angle - turns * half_pi[0]; // exact: both are multiples of 2^-53, the result is below 1
    const Pair second = two_difference(first, turns * half_pi[1]);
    const Pair third = two_difference(second.hi, turns * half_pi[2]);
    const double tail = (second.lo + third.lo) - turns * half_pi[3];
    const Pair sum = two_sum(third.hi, tail);
    return {sum, static_cast<int>(std::bit_cast<std::uint64_t>(shifted) & 3U)};
}

// The Taylor series, whose remainders at pi/4 are below 2^-63 and 2^-59 of the result; T is double or Two.
// Their terms are added in pairs, pairs of pairs and so on (G. Estrin 1960), which wait less for each other.
template <class T> T sine(T hi, T lo)
{
    const T s = hi * hi, s2 = s * s;
    const T first = -1.0 / 6 + s * (1.0 / 120), second = -1.0 / 5040 + s * (1.0 / 362880);
    const T third = -1.0 / 39916800 + s * (1.0 / 6227020800);
    const T fourth = -1.0 / 1307674368000 + s * (1.0 / 355687428096000);
    const T p = s * ((first + s2 * second) + (s2 * s2) * (third + s2 * fourth));
    return hi + (hi * p + lo * (1 - 0.5 * s));
}

template <class T> T cosine(T hi, T lo)
{
    const auto square = two_product(hi, hi);
    const T s = square.hi, s2 = s * s;
    const T first = 1.0 / 24 + s * (-1.0 / 720), second = 1.0 / 40320 + s * (-1.0 / 3628800);
    const T third = 1.0 / 479001600 + s * (-1.0 / 87178291200) + s2 * (1.0 / 20922789888000);
    const T p = s2 * ((first + s2 * second) + (s2 * s2) * third);
    const auto one_less = two_sum(T{} + 1, -0.5 * s);
    return one_less.hi + (one_less.lo + (p - 0.5 * square.lo - hi * lo));
}

/// Those of an angle that so many quarter turns were taken off.
SinCos turned_on(double s, double c, int quarter)
{
    switch (quarter) {
    case 0:
        return {s, c};
    case 1:
        return {c, -s};
    case 2:
        return {-s, -c};
    default:
        return {-c, s};
    }
}

} // namespace

SinCos sin_cos(double angle)
{
    const auto [x, quarter] = reduce(angle);
    return turned_on(sine(x.hi, x.lo), cosine(x.hi, x.lo), quarter);
}

TwoSinCos sin_cos(double first, double second)
{
    const Reduced a = reduce(first), b = reduce(second);
    const Two hi{a.angle.hi, b.angle.hi}, lo{a.angle.lo, b.angle.lo};
    const Two s = sine(hi, lo), c = cosine(hi, lo);
    return {turned_on(s[0], c[0], a.quarter), turned_on(s[1], c[1], b.quarter)};
}

double angle_of(SinCos d)
{
    const double small = std::fabs(d.cos) < d.sin ? std::fabs(d.cos) : d.sin;
    const double large = std::fabs(d.cos) < d.sin ? d.sin : std::fabs(d.cos);
    const double m = small / large;
    double angle = m / (1 + 0.28 * m * m); // arc tangent to 0.005
    const double quarter = half_pi[0] + half_pi[1];
    if (std::fabs(d.cos) < d.sin) angle = quarter - angle;
    if (d.cos < 0) angle = 2 * quarter - angle;
    for (int i = 0; i < 2; ++i) { // the error e becomes e^3 / 6
        const SinCos at = sin_cos(angle);
        angle += d.sin * at.cos - d.cos * at.sin;
    }
    return angle;
}

} // namespace brink
