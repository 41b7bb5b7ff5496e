// SPDX-License-Identifier: BSD-3-Clause
#include "round_axis.h"

#include "support.h"

#include <algorithm>

namespace brink {

namespace {

/// Enough to double the digits from two to all of them, and for as many steps too long.
constexpr int most_rounds = 8;
/// Of a direction, in radians: half of a double's digits.
constexpr double apart = 0x1p-20;
/// Steps longer than this leave the neighbourhood.
constexpr double longest_step = 0.25;

struct Slope {
    double e, f;
};

/// The gap along axes about a given one, as a function of a step along two directions at right angles to it.
class Chart {
public:
    Chart(const Core& a, const Core& b, V3 axis)
        : a_(a), b_(b), axis_(axis), e_(any_perpendicular(axis)), f_(cross(axis, e_))
    {
    }

    V3 direction(Slope step) const { return axis_ + (step.e * e_ + step.f * f_); }

    Slope slope(Slope step) const
    {
        const V3 n = direction(step), w = farthest(b_, -n).point - farthest(a_, n).point;
        const double square = norm_squared(n), lean = dot(w, n) / square, length = std::sqrt(square);
        return {(dot(w, e_) - lean * dot(n, e_)) / length, (dot(w, f_) - lean * dot(n, f_)) / length};
    }

    /// Where the slope vanishes, were it linear.
    Slope newton(Slope here) const
    {
        const Slope by_e = slope({apart, 0}), by_f = slope({0, apart});
        const double ee = (by_e.e - here.e) / apart, ff = (by_f.f - here.f) / apart;
        const double ef = 0.5 * ((by_e.f - here.f) + (by_f.e - here.e)) / apart;
        const double determinant = ee * ff - ef * ef;
        if (!(ee + ff < 0 && determinant > 0)) return {here.e, here.f}; // no top nearby: upwards
        return {(ef * here.f - ff * here.e) / determinant, (ef * here.e - ee * here.f) / determinant};
    }

private:
    const Core& a_;
    const Core& b_;
    V3 axis_, e_, f_;
};

Slope shortened(Slope s)
{
    const double length = std::sqrt(s.e * s.e + s.f * s.f);
    const double share = length > longest_step ? longest_step / length : 1;
    return {share * s.e, share * s.f};
}

/// What a step leads to, or half of it and so on: the first axis that is better than the best.
Axis better(const Core& a, const Core& b, const Axis& best, const Chart& chart, Slope step)
{
    for (int halving = 0; halving < most_rounds; ++halving) {
        const V3 n = chart.direction(step), normal = (1 / norm(n)) * n;
        const double gap = gap_along(a, b, normal);
        if (gap > best.gap) return {gap, normal};
        step = {0.5 * step.e, 0.5 * step.f};
    }
    return best;
}

} // namespace

LocalTop locally_best(const Core& a, const Core& b, const Axis& start, double slack)
{
    // What a slope leaves to climb is about its square, in lengths of the two cores.
    const double flat = slack * std::max(extent(a), extent(b));
    Axis best = start;
    for (int round = 0; round < most_rounds; ++round) {
        const Chart chart(a, b, best.normal);
        const Slope here = chart.slope({0, 0});
        const double square = here.e * here.e + here.f * here.f;
        if (square <= slack * slack) return {best, true};
        const Axis next = better(a, b, best, chart, shortened(chart.newton(here)));
        if (!(next.gap > best.gap)) return {best, square <= flat};
        best = next;
    }
    return {best, false};
}

} // namespace brink
