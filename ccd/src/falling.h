// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/pose.h>

#include <algorithm>
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

/// The last h, less a small part, at which `concave(h)` is not less than curvature h^2 / 2; so it is from 0
/// on. No later than the horizon; 0 where it is less at 0. Chords lie below the function and lead to where it
/// still is enough; lines through the last two such places, extended, lie above and lead to where it is no
/// more.
template <class Function> double last_kept(const Function& concave, double curvature, double horizon)
{
    constexpr int most_rounds = 24;
    constexpr double part = 0x1p-21;
    const auto spare = [&](double h) { return concave(h) - 0.5 * curvature * h * h; };
    // The root of a line through two places less the parabola, from the first one on.
    const auto root = [&](double h, double at, double to, double at_to) {
        const double fall = 0.5 * curvature * h * h, fall_to = 0.5 * curvature * to * to;
        const double slope = (at_to + fall_to - at - fall) / (to - h) - curvature * h;
        return h + falls(at, slope, curvature);
    };
    double good = 0, at_good = spare(0), bad = horizon, at_bad = spare(horizon);
    if (!(at_good >= 0)) return 0;
    if (at_bad >= 0) return horizon;
    double before = 0, at_before = at_good;
    const auto look = [&](double h) {
        if (!(h > good && h < bad)) return;
        const double at = spare(h);
        if (!(at >= 0)) {
            bad = h, at_bad = at;
            return;
        }
        before = good, at_before = at_good;
        good = h, at_good = at;
    };
    for (int i = 0; i < most_rounds && bad - good > part * bad; ++i) {
        const double width = bad - good;
        look(root(good, at_good, bad, at_bad));
        if (good > before) look((1 + 0.5 * part) * root(before, at_before, good, at_good));
        if (bad - good > 0.5 * width) look(good > 0 ? std::sqrt(good * bad) : part * bad);
    }
    return good;
}

/// About where between two places a concave function is highest, by golden sections; `enough` tells by the
/// width that is left and the highest value so far whether that is near enough.
template <class Function, class Enough>
double highest_place(const Function& f, double low, double high, const Enough& enough)
{
    constexpr double golden = 0.6180339887498949;
    double a = high - golden * (high - low), b = low + golden * (high - low), at_a = f(a), at_b = f(b);
    while (!enough(high - low, std::max(at_a, at_b))) {
        if (at_a < at_b) {
            low = a, a = b, at_a = at_b;
            b = low + golden * (high - low), at_b = f(b);
        } else {
            high = b, b = a, at_b = at_a;
            a = high - golden * (high - low), at_a = f(a);
        }
    }
    const double best = at_a < at_b ? b : a, at_best = std::max(at_a, at_b);
    if (f(low) > at_best) return low; // as at the very ends
    return f(high) > at_best ? high : best;
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
