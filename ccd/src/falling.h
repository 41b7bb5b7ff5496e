// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/pose.h>

#include <cmath>

/// When gaps fall, as far as their values and rates tell; and what concave functions are asked.
namespace brink {

/// Where the parabola above + slope h - curvature h^2 / 2 falls to zero.
static inline double falls(double above, double slope, double curvature)
{
    const double root = std::sqrt(slope * slope + 2 * curvature * above);
    if (slope > 0) return curvature > 0 ? (slope + root) / curvature : infinity;
    return root - slope > 0 ? 2 * above / (root - slope) : infinity;
}

/// The last h at which a concave function, which is not negative at 0, is not negative either; no later than
/// the horizon.
template <class Function> double last_kept(const Function& f, double horizon)
{
    constexpr int bisections = 48;
    if (!(f(0) >= 0)) return 0;
    if (f(horizon) >= 0) return horizon;
    double good = 0, bad = horizon;
    for (int i = 0; i < bisections; ++i) {
        const double h = 0.5 * (good + bad);
        (f(h) >= 0 ? good : bad) = h;
    }
    return good;
}

/// About where between two places a concave function is highest.
template <class Function> double highest_place(const Function& f, double low, double high, int thirds)
{
    for (int i = 0; i < thirds; ++i) {
        const double third = (high - low) / 3, a = low + third, b = high - third;
        if (f(a) < f(b))
            low = a;
        else
            high = b;
    }
    return low;
}

/// A gap, and how fast it grows.
struct Trend {
    double now = 0, rate = 0;
};

/// The gap at some time.
struct Guess {
    double time;
    Trend gap;
};

/// When the gap falls to `aim`, by the last guess and, where its bend is no more than a correction, by a
/// cubic for the time as a function of the gap through both.
static inline double falls_to(double aim, const Guess& before, const Guess& last)
{
    const double rise = before.gap.now - last.gap.now, left = aim - last.gap.now;
    const double per_rise = 1 / rise, slope = 1 / last.gap.rate, slope_before = 1 / before.gap.rate;
    const double newton = left * slope, secant = (before.time - last.time) * per_rise;
    const double at_last = (secant - slope) * per_rise, at_before = (slope_before - secant) * per_rise;
    const double bend = left * left * (at_last + (aim - before.gap.now) * ((at_before - at_last) * per_rise));
    return last.time + (std::fabs(bend) <= 0.5 * std::fabs(newton) ? newton + bend : newton);
}

} // namespace brink
