// SPDX-License-Identifier: BSD-3-Clause
#include "round_axis.h"

#include "simplex.h"
#include "support.h"

#include <algorithm>

namespace brink {

namespace {

constexpr int most_rounds = 12, most_rounds_nearly = 6;
/// Of a direction, in radians: half of a double's digits.
constexpr double apart = 0x1p-20;
/// The same where only the ends of a line are asked for.
constexpr double closest = 0x1p-38;
/// A supporting point that turns with its direction by more than this, in lengths per radian and in lengths
/// of the cores, jumps from one end of a line to the other.
constexpr double jump = 0x1p10;
/// Steps longer than this, in radians, leave the neighbourhood.
constexpr double longest_step = 0.25;
/// Steps whose directions agree to this cosine, and that shrink at all, make a sequence.
constexpr double same_way = 0.98, longest_share = 0.99;

using Corner = Simplex::Corner;

/// The gap along axes about a given one, and how it changes, in two directions at right angles to it.
class Chart {
public:
    Chart(const Core& a, const Core& b, V3 axis, double size)
        : a_(a), b_(b), axis_(axis), size_(size), here_(support(axis))
    {
        nearest_.add(here_);
    }
    /// Needed by step(), gain() and, of lines, top().
    void look_around();

    /// A step to where the gap is the largest.
    V3 step() const;
    /// A point of the difference that lies lowest along the axis.
    V3 lowest() const { return here_.w; }
    /// What it promises to gain.
    double gain() const { return std::fabs(first_.gain) + std::fabs(second_.gain); }
    /// Where the difference comes nearest to the origin, and the axis, which is a top or not.
    LocalTop top(const Axis& axis, bool top) const
    {
        LocalTop t{axis, top, {}, nearest_.point()};
        for (int k = 0; k < nearest_.size; ++k)
            t.point_a = t.point_a + nearest_.corners[k].weight * nearest_.corners[k].on_a;
        return t;
    }

private:
    struct Way {
        V3 direction;
        double step = 0, gain = 0;
    };

    Corner support(V3 n) const
    {
        const SupportPoint on_a = farthest(a_, n), on_b = farthest(b_, -n);
        return {on_b.point - on_a.point, on_a.point, on_b.point, on_a.corner, on_b.corner, 1};
    }
    struct Ends {
        Corner behind, ahead;
        V3 line() const { return ahead.w - behind.w; }
    };
    Ends ends(V3 direction, double side) const
    {
        return {support(axis_ - side * direction), support(axis_ + side * direction)};
    }
    Ends ends_of_line(V3 direction) const;
    double bend(V3 direction) const { return 0.5 / apart * dot(ends(direction, apart).line(), direction); }
    bool jumps(double bend) const { return bend < -jump * size_; }
    Way smooth(V3 direction, double bend, V3 nearest) const;
    Way upright(V3 direction, const Ends&) const;
    void stand_on_ridge(V3 direction);

    const Core& a_;
    const Core& b_;
    V3 axis_;
    double size_;
    Corner here_;
    Simplex nearest_;
    Way first_, second_;
};

void Chart::look_around()
{
    const V3 e = any_perpendicular(axis_), f = cross(axis_, e);
    const V3 by_e = ends(e, apart).line(), by_f = ends(f, apart).line();
    const double scale = 0.5 / apart, ee = scale * dot(by_e, e), ff = scale * dot(by_f, f);
    const double ef = 0.5 * scale * (dot(by_e, f) + dot(by_f, e)), half = 0.5 * (ee - ff);
    // The directions in which the bend is strongest and weakest.
    const double root = std::sqrt(half * half + ef * ef), strong = 0.5 * (ee + ff) - root;
    V3 way = half <= 0 ? (half - root) * e + ef * f : ef * e - (half + root) * f;
    way = norm(way) > 0 ? (1 / norm(way)) * way : e;
    if (jumps(strong)) {
        stand_on_ridge(way);
        return;
    }
    first_ = smooth(way, strong, here_.w);
    second_ = smooth(cross(axis_, way), 0.5 * (ee + ff) + root, here_.w);
}

/// A way of two that do not bend into each other.
Chart::Way Chart::smooth(V3 direction, double bend, V3 nearest) const
{
    const double slope = dot(nearest, direction);
    const double curvature = bend - dot(axis_, here_.w); // of the unit sphere, too
    const double step = curvature < 0 ? -slope / curvature : slope / size_;
    return {direction, step, 0.5 * slope * step};
}

/// To where the axis stands upright on a line.
Chart::Way Chart::upright(V3 direction, const Ends& ends) const
{
    const double across = dot(ends.line(), direction);
    if (!(across < 0)) return {direction};
    const double step = -dot(ends.line(), axis_) / across;
    return {direction, step, step * across};
}

/// Both ends of a line that lies against the plane, by turning as little as shows them: other surfaces roll
/// on meanwhile.
Chart::Ends Chart::ends_of_line(V3 direction) const
{
    const Ends near = ends(direction, closest);
    return dot(near.line(), direction) < -2 * apart * jump * size_ ? near : ends(direction, apart);
}

void Chart::stand_on_ridge(V3 direction)
{
    const V3 rough = ends_of_line(direction).line(), flat = rough - dot(rough, axis_) * axis_;
    if (!(norm(flat) > 0)) return;
    const V3 way = (-1 / norm(flat)) * flat, other = cross(axis_, way);
    const Ends line = ends_of_line(way);
    first_ = upright(way, line);
    nearest_ = {};
    nearest_.add(line.behind);
    nearest_.add(line.ahead);
    nearest_.reduce();
    const double bend_of_other = bend(other);
    if (!jumps(bend_of_other)) {
        second_ = smooth(other, bend_of_other, nearest_.point());
        return;
    }
    const Ends crossing = ends_of_line(other);
    second_ = upright(other, crossing);
    for (const Corner& end : {crossing.behind, crossing.ahead}) {
        if (nearest_.contains(end) || nearest_.size == 4) continue;
        nearest_.add(end);
        nearest_.reduce(Simplex::Origin::outside); // all lie in one plane, to rounding
    }
}

V3 Chart::step() const
{
    const V3 s = first_.step * first_.direction + second_.step * second_.direction;
    const double length = norm(s);
    return length > longest_step ? (longest_step / length) * s : s;
}

/// Steps that shrink by the same share again and again, because a line rolls along as the axis turns about
/// it, are taken all at once (Aitken).
V3 hastened(V3 step, V3& last)
{
    const double length = norm(step), before = norm(last);
    const bool again = dot(step, last) > same_way * length * before && length < longest_share * before;
    last = again ? V3{} : step;
    return again ? (1 / (1 - length / before)) * step : step;
}

/// What part of the way from an axis to a better one to go back: as far as the top of a ridge between them,
/// where the points that lie lowest along the two are as low, and half of it on a smooth surface.
double way_back(V3 axis, V3 lowest, V3 better, V3 lowest_of_better)
{
    const V3 line = lowest - lowest_of_better;
    const double here = dot(axis, line), there = dot(better, line);
    return here < 0 && there >= 0 ? here / (here - there) : 0.5;
}

} // namespace

LocalTop locally_best(const Core& a, const Core& b, const Axis& start, double slack)
{
    const double size = std::max(extent(a), extent(b));
    LocalTop best;
    V3 axis = start.normal, last;
    double most = -infinity;
    for (int round = 0; round < most_rounds; ++round) {
        Chart chart(a, b, axis, size);
        chart.look_around();
        const double gap = gap_along(a, b, axis);
        const bool better = !(gap < most - 0.25 * slack); // below that it is rounding
        if (better) {
            best = chart.top({gap, axis}, chart.gain() <= slack);
            most = std::max(most, gap);
        }
        const V3 top = best.axis.normal;
        const V3 step = better ? hastened(chart.step(), last)
                               : way_back(axis, chart.lowest(), top, best.v) * (top - axis);
        if (!(norm_squared(step) > tolerance::epsilon * tolerance::epsilon)) break;
        axis = axis + step;
        axis = (1 / norm(axis)) * axis;
    }
    return best;
}

LocalTop nearly_best(const Core& a, const Core& b, V3 start, const Nearness& near)
{
    const double size = std::max(extent(a), extent(b));
    V3 axis = start, last;
    double most = -infinity;
    for (int round = 0; round < most_rounds_nearly; ++round) {
        Chart chart(a, b, axis, size);
        const auto found = [&] {
            LocalTop here = chart.top({dot(axis, chart.lowest()), axis}, false);
            const double gap = here.axis.gap, distance = norm(here.v);
            const double enough = near.slack + near.relative * std::max(0.0, distance - near.reach);
            here.top = gap > 0 && distance - gap <= enough;
            return here;
        };
        LocalTop here = found();
        if (here.top) return here;
        if (!(here.axis.gap > most)) break;
        most = here.axis.gap;
        chart.look_around();
        here = found();
        if (here.top) return here;
        axis = axis + hastened(chart.step(), last);
        axis = (1 / norm(axis)) * axis;
    }
    return {};
}

} // namespace brink
