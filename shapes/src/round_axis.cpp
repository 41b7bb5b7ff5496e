// SPDX-License-Identifier: BSD-3-Clause
#include "round_axis.h"

#include "simplex.h"
#include "support.h"

#include <algorithm>

namespace brink {

namespace {

constexpr int most_rounds = 12;
/// Of a direction, in radians: half of a double's digits.
constexpr double apart = 0x1p-20;
/// A supporting point that turns with its direction by more than this, in lengths per radian and in lengths
/// of the cores, jumps from one end of a line to the other.
constexpr double jump = 0x1p10;
/// Steps longer than this, in radians, leave the neighbourhood.
constexpr double longest_step = 0.25;

using Corner = Simplex::Corner;

/// The gap along axes about a given one, and how it changes, in two directions at right angles to it.
class Chart {
public:
    Chart(const Core& a, const Core& b, V3 axis, double size);

    /// A step to where the gap is the largest.
    V3 step() const;
    /// What it promises to gain.
    double gain() const { return std::fabs(first_.gain) + std::fabs(second_.gain); }
    /// Where the difference comes nearest to the origin.
    Simplex nearest() const { return nearest_; }

private:
    struct Way {
        V3 direction;
        double step = 0, gain = 0;
    };

    Corner support(V3 n) const
    {
        const SupportPoint on_a = farthest(a_, n), on_b = farthest(b_, -n);
        return {on_b.point - on_a.point, on_a.point, on_a.corner, on_b.corner, 1};
    }
    Way along(V3 direction, double bend);

    const Core& a_;
    const Core& b_;
    V3 axis_;
    double size_;
    Corner here_;
    Simplex nearest_;
    Way first_, second_;
};

Chart::Chart(const Core& a, const Core& b, V3 axis, double size)
    : a_(a), b_(b), axis_(axis), size_(size), here_(support(axis)), nearest_{1, {here_}}
{
    const V3 e = any_perpendicular(axis), f = cross(axis, e);
    const V3 by_e = support(axis + apart * e).w - support(axis - apart * e).w;
    const V3 by_f = support(axis + apart * f).w - support(axis - apart * f).w;
    const double scale = 0.5 / apart, ee = scale * dot(by_e, e), ff = scale * dot(by_f, f);
    const double ef = 0.5 * scale * (dot(by_e, f) + dot(by_f, e)), half = 0.5 * (ee - ff);
    // The directions in which the bend is strongest and weakest.
    const double root = std::sqrt(half * half + ef * ef), strong = 0.5 * (ee + ff) - root;
    V3 way = half <= 0 ? (half - root) * e + ef * f : ef * e - (half + root) * f;
    way = norm(way) > 0 ? (1 / norm(way)) * way : e;
    first_ = along(way, strong);
    second_ = along(cross(axis, way), 0.5 * (ee + ff) + root);
}

/// One way of two that do not bend into each other.
Chart::Way Chart::along(V3 direction, double bend)
{
    Way way{direction, 0, 0};
    const double gap = dot(axis_, here_.w);
    if (bend < -jump * size_) {
        const Corner ahead = support(axis_ + apart * direction), behind = support(axis_ - apart * direction);
        const V3 line = ahead.w - behind.w;
        const double across = dot(line, direction);
        if (!(across < 0)) return way;
        way.step = -dot(line, axis_) / across;
        way.gain = way.step * across;
        nearest_ = Simplex{2, {behind, ahead}}.reduced();
        return way;
    }
    const double slope = dot(here_.w, direction), curvature = bend - gap; // of the unit sphere, too
    way.step = curvature < 0 ? -slope / curvature : slope / size_;
    way.gain = 0.5 * slope * way.step;
    return way;
}

V3 Chart::step() const
{
    const V3 s = first_.step * first_.direction + second_.step * second_.direction;
    const double length = norm(s);
    return length > longest_step ? (longest_step / length) * s : s;
}

} // namespace

LocalTop locally_best(const Core& a, const Core& b, const Axis& start, double slack)
{
    const double size = std::max(extent(a), extent(b));
    LocalTop best;
    V3 axis = start.normal;
    double most = -infinity;
    for (int round = 0; round < most_rounds; ++round) {
        const Chart chart(a, b, axis, size);
        const double gap = gap_along(a, b, axis);
        const bool better = !(gap < most - 0.25 * slack); // below that it is rounding
        if (better) {
            const Simplex s = chart.nearest();
            best = {{gap, axis}, chart.gain() <= slack, {}, s.point()};
            for (int k = 0; k < s.size; ++k)
                best.point_a = best.point_a + s.corners[k].weight * s.corners[k].on_a;
            most = std::max(most, gap);
        }
        const V3 step = better ? chart.step() : 0.5 * (best.axis.normal - axis);
        if (!(norm_squared(step) > tolerance::epsilon * tolerance::epsilon)) break;
        axis = axis + step;
        axis = (1 / norm(axis)) * axis;
    }
    return best;
}

} // namespace brink
