// SPDX-License-Identifier: BSD-3-Clause
#include "certificate.h"

#include "lanes.h"
#include "shadow.h"
#include "support.h"
#include "tolerance.h"
#include "trend.h"

#include <algorithm>
#include <type_traits>

namespace brink {

namespace {

constexpr int newton_rounds = 8;

/// phi(h) = value + slope h - curvature h^2 / 2 <= gap(t + h) for h in [0, horizon]: every pair of points at
/// once, because the extreme points are those of an axis that moves linearly. phi is concave. Proof:
/// numerics.md.
template <class Part, class Seen = Shadows<Part>> class Bound {
public:
    Bound(const Facing<Part>& f, const TurningAxis& axis, double horizon)
        : f_(f),
          axis_(axis),
          rates_(pair(f.a.rate, f.b.rate)),
          relative_(rates_ - both(axis.spin)),
          shift_(cross(both(axis.normal), relative_)),
          seen_(f.a, f.b, axis.normal, shift_),
          drift_(cross(axis.spin, axis.normal)),
          rest_{-f.margin, dot(axis.normal, f.velocity) + dot(drift_, f.b.pivot)},
          now_(seen_.now() + rest_),
          horizon_(horizon)
    {
    }
    /// Needed by all that follows.
    void bend_towards()
    {
        // Past the root of its tangent a concave function is negative.
        if (now_.slope < 0 && now_.value > 0) horizon_ = std::min(horizon_, now_.value / -now_.slope);
        const double spin = norm(axis_.spin);
        const XYZ<Two> across = cross(rates_, both(axis_.spin));
        const Bend of_each = bend(across, spin);
        curvature_ = of_each.second[0] + of_each.second[1];
        third_ = of_each.third[0] + of_each.third[1];
        if (spin > 0) {
            const Two away = norm(pair(f_.b.pivot, f_.b.pivot + horizon_ * f_.velocity));
            const Two moved = norm(pair(drift_, f_.velocity));
            const double far = std::max(away[0], away[1]), turn = moved[0], speed = moved[1];
            curvature_ += spin * turn * far + 2 * turn * speed;
            third_ += spin * (spin * turn * far + 3 * turn * speed);
        }
        either_way_ = curvature_;
        if (!(curvature_ * horizon_ * horizon_ > tolerance::much_curved * std::fabs(now_.value))) return;
        if (now_.value > 0 && reaches(0, now_) >= horizon_) return; // this will do
        sharpen(across);
    }

    double curvature() const { return curvature_; }
    /// A bound of minus the second derivative of all pairs of points, but of boxes
    double steepest() const { return std::min(either_way_, curvature_ + 2 * third_ * horizon_ / 3); }
    /// and of the second derivative whatever its sign.
    double either_way() const { return either_way_; }
    /// As far as all this holds.
    double horizon() const { return horizon_; }
    Line now() const { return now_; }
    Line line(double h) const { return seen_.between(h) + rest_; }
    double bent(double h, Line l) const { return l.at(h) - 0.5 * curvature_ * h * h; }
    /// Where the parabola through this line falls to `level`; never before phi itself does.
    double reaches(double level, Line l) const
    {
        return falls(std::max(0.0, l.value - level), l.slope, curvature_);
    }

    struct Last {
        double h, value; // phi(h) or, beyond the last h with phi >= level, a little less than the level
    };
    /// Newton's method from outside: the largest h, or a little more, with phi(h) >= level.
    Last last(double level) const
    {
        double x = std::min(horizon_, reaches(level, now_));
        for (int i = 0;; ++i) {
            const Line l = line(x);
            const double value = bent(x, l);
            if (value >= level || i == newton_rounds) return {x, value};
            const double next = reaches(level, l);
            if (!(next < x)) return {x, value};
            x = next;
        }
    }

private:
    /// By the second derivatives now, as far as the third lets them change. A horizon that is not far beyond
    /// where the bound falls makes both sharper.
    void sharpen(const XYZ<Two>& across)
    {
        // The second derivative of n . x now is x . this.
        const XYZ<Two> normal = both(axis_.normal);
        const XYZ<Two> now = cross(normal, across) + cross(relative_, cross(relative_, normal));
        const auto reach = Seen::reach(f_.a, f_.b, pair(first(now), -second(now)));
        const double of_pivots = dot(cross(axis_.spin, drift_), f_.b.pivot) + 2 * dot(drift_, f_.velocity);
        const auto until = [&](double h) {
            return std::min(either_way_, std::max(0.0, seen_.until(h, reach) - of_pivots) + third_ * h / 3);
        };
        curvature_ = until(horizon_);
        const double beyond = now_.value > 0 ? tolerance::beyond_fall * reaches(0, now_) : infinity;
        if (!(beyond < horizon_)) return;
        horizon_ = beyond;
        curvature_ = until(horizon_);
    }
    /// What each body adds to the bounds of the second and third derivative of n . x while n turns; none
    /// where the axis is glued to it.
    struct Bend {
        Two second, third;
    };
    /// `across` are the cross products of the rates and the spin.
    Bend bend(const XYZ<Two>& across, double spin) const
    {
        const Two reach{f_.a.reach, f_.b.reach};
        if (spin == 0) {
            const Two angle{f_.a.angle, f_.b.angle}, second = reach * (norm(shift_) * angle);
            return {second, second * angle};
        }
        const Two rate = norm(relative_), turn = norm(across);
        return {reach * (turn + rate * rate),
                reach * (rate * rate * rate + both(3) * rate * turn + both(spin) * turn)};
    }

    const Facing<Part>& f_;
    const TurningAxis& axis_;
    XYZ<Two> rates_, relative_, shift_; // A's and B's
    Seen seen_;
    V3 drift_;
    Line rest_; // of the gap: what is the same for all points
    Line now_;
    double horizon_, curvature_ = 0, either_way_ = 0, third_ = 0;
};

/// A bound of the second derivative of the distance of any two points, one of each body, that is never less
/// than `apart`: seen from a frame that turns.
double distance_bend(const Facing<Core>& f, V3 spin, double apart, double horizon)
{
    double speed = 0, pull = 0;
    for (const V3 pivot : {f.b.pivot, f.b.pivot + horizon * f.velocity}) {
        const V3 carried = cross(spin, pivot);
        speed = std::max(speed, norm(f.velocity - carried));
        pull = std::max(pull, norm(carried));
    }
    double bend = norm(spin) * pull + 2 * norm(cross(spin, f.velocity));
    for (const Posed<Core>& body : {f.a, f.b}) {
        const double rate = norm(body.rate - spin);
        speed += body.reach * rate;
        bend += body.reach * (rate * rate + norm(cross(body.rate, spin)));
    }
    return bend + speed * speed / apart;
}

/// Does with a bound what is to be done; of the commonest cores with one made for them.
template <class Part, class Do>
auto with_bound(const Facing<Part>& f, const TurningAxis& axis, double horizon, Do go)
{
    const auto with = [&](auto bound_of) {
        typename decltype(bound_of)::type bound(f, axis, horizon);
        return go(bound);
    };
    using enum Core::Kind;
    if constexpr (std::is_same_v<Part, Core>) {
        const Core::Kind a = f.a.part.kind, b = f.b.part.kind;
        if (a == box && b == box) return with(std::type_identity<Bound<Part, BoxShadows>>{});
        if (a == segment && b == box)
            return with(std::type_identity<Bound<Part, Shadows<Part, SegmentShadow, BoxShadow>>>{});
        if (a == segment && b == segment)
            return with(std::type_identity<Bound<Part, Shadows<Part, SegmentShadow, SegmentShadow>>>{});
    }
    return with(std::type_identity<Bound<Part>>{});
}

} // namespace

template <class Part> Step safe_step(const Facing<Part>& f, const TurningAxis& axis, double horizon)
{
    return with_bound(f, axis, horizon, [](auto& bound) -> Step {
        Step step{bound.now().value, 0, 0};
        if (!(step.gap > 0)) return step;
        bound.bend_towards();
        const auto [x, left] = bound.last(0);
        // The chord lies below a concave function.
        step.length = left >= 0 ? x : x * (step.gap / (step.gap - left)) * tolerance::step_shrink;
        step.residual = bound.curvature() * step.length * step.length;
        return step;
    });
}

template <class Part> double rising_step(const Facing<Part>& f, const TurningAxis& axis, double horizon)
{
    Bound<Part> bound(f, axis, horizon);
    bound.bend_towards();
    const double level = bound.now().value;
    const auto [x, value] = bound.last(level);
    if (value >= level) return x;
    const double half = 0.5 * x; // the top of a parabola; further on the bound falls again
    return bound.bent(half, bound.line(half)) >= level ? half : 0;
}

double growing_step(const Facing<Border>& f, const TurningAxis& axis, double horizon)
{
    Bound<Border> bound(f, axis, horizon);
    bound.bend_towards();
    const double level = bound.now().value, rate = bound.now().slope;
    if (!(rate >= 0)) return 0;
    const double most = bound.last(level).h;
    const double bent = 0.5 * (bound.steepest() + bound.either_way());
    double step = 0;
    for (const double h : {most, 0.5 * most}) {
        const Line l = bound.line(h);
        const double gained = (l.value - level) + h * l.slope, needed = rate + bent * h;
        step = std::max(step, gained >= h * needed ? h : gained / needed);
    }
    if (f.b.part.solid) return step;
    const TurningAxis away{-axis.normal, axis.spin};
    Bound<Border> behind(f, away, step);
    behind.bend_towards();
    const double lead = std::max(0.0, level - behind.now().value), gains = behind.now().slope;
    if (lead == 0 && gains == 0 && behind.either_way() > 0) return 0;
    return std::min(step, falls(lead, -gains, behind.either_way()));
}

double growing_step(const Facing<Core>& f, const TurningAxis& axis, const Separation& now, double horizon)
{
    const V3 on_a = now.point_a - f.a.part.radius * now.normal;
    const V3 on_b = now.point_b + f.b.part.radius * now.normal;
    const double distance = norm(on_b - on_a);
    Bound<Core> bound(f, axis, horizon);
    const double apart = bound.now().value + f.margin;
    if (!(distance > 0 && apart > 0 && bound.now().slope >= 0)) return 0;
    bound.bend_towards();
    const double rate = trend(f, {(1 / distance) * (on_b - on_a), {}}, on_a, on_b).rate;
    const double bend = distance_bend(f, axis.spin, apart, horizon);
    const double later = std::min(bound.horizon(), 2 * rate / (2 * bound.curvature() + bend));
    const double gained = bound.bent(later, bound.line(later)) + f.margin - distance;
    const double spare = gained - 0.5 * bend * later * later;
    if (!(later > 0 && spare >= 0)) return 0;
    return std::min(later, falls(spare, bend * later - rate, 2 * bend));
}

double closing_rate(const Facing<Core>& f, V3 axis)
{
    return norm(cross(axis, f.a.rate)) * f.a.reach + norm(cross(axis, f.b.rate)) * f.b.reach -
           dot(axis, f.velocity);
}

template Step safe_step(const Facing<Core>&, const TurningAxis&, double);
template Step safe_step(const Facing<Border>&, const TurningAxis&, double);
template double rising_step(const Facing<Core>&, const TurningAxis&, double);
template double rising_step(const Facing<Border>&, const TurningAxis&, double);

} // namespace brink
