// SPDX-License-Identifier: BSD-3-Clause
#include "certificate.h"

#include "support.h"
#include "tolerance.h"

#include <algorithm>

namespace brink {

namespace {

constexpr int newton_rounds = 8;

/// The points that support the turning axis at some h, as a line in h.
struct Piece {
    double value, slope;
};

/// A's farthest point along the axis, and B's nearest.
Piece leading(const Posed<Core>& a, V3 axis, V3 shift, double h)
{
    const V3 p = farthest(a.part, axis + h * shift).point;
    return {dot(axis, p), dot(shift, p)};
}
Piece trailing(const Posed<Core>& b, V3 axis, V3 shift, double h)
{
    const V3 p = farthest(b.part, -(axis + h * shift)).point;
    return {dot(axis, p), dot(shift, p - b.pivot)};
}
/// A plane has one possible axis, its own normal, which stays with it.
Piece trailing(const Posed<Border>& b, V3 axis, V3, double)
{
    return {dot(axis, b.part.normal) < 0 ? -b.part.offset : b.part.offset, 0};
}

/// The largest x . q over a body's points about its pivot.
double reach_along(const Posed<Core>& body, V3 q)
{
    return dot(q, farthest(body.part, q).point - body.pivot);
}
double reach_along(const Posed<Border>&, V3) { return 0; }

/// What one body adds to the bounds of the second and third derivative of n . x while n turns.
struct Bend {
    double second, third;
    V3 now; // the second derivative of n . x now is x . now
};

template <class Part> Bend bend(const Posed<Part>& body, const Axis& n)
{
    const V3 relative = body.rate - n.spin, u = cross(body.rate, n.spin);
    const double rate = norm(relative), turn = norm(u), spin = norm(n.spin);
    const double across = spin == 0 ? norm(cross(n.normal, relative)) : rate;
    return {body.reach * (turn + across * rate),
            body.reach * (across * rate * rate + 3 * rate * turn + spin * turn),
            cross(n.normal, u) + cross(relative, cross(relative, n.normal))};
}

/// phi(h) = value + slope h - curvature h^2 / 2 <= gap(t + h) for h in [0, horizon]: every pair of points at
/// once, because the extreme points are those of an axis that moves linearly. phi is concave. Proof:
/// numerics.md.
template <class Part> class Bound {
public:
    Bound(const Facing<Part>& f, const Axis& axis, double horizon)
        : f_(f),
          axis_(axis),
          shift_a_(cross(axis.normal, f.a.rate - axis.spin)),
          shift_b_(cross(axis.normal, f.b.rate - axis.spin)),
          drift_(cross(axis.spin, axis.normal)),
          slope_(dot(axis.normal, f.velocity) + dot(drift_, f.b.pivot)),
          now_(piece(0)),
          horizon_(horizon)
    {
        // Past the root of its tangent a concave function is negative.
        if (now_.slope < 0 && now_.value > 0) horizon_ = std::min(horizon, now_.value / -now_.slope);
        const double far = std::max(norm(f.b.pivot), norm(f.b.pivot + horizon_ * f.velocity));
        const double spin = norm(axis.spin), turn = norm(drift_), speed = norm(f.velocity);
        const Bend a = bend(f.a, axis), b = bend(f.b, axis);
        curvature_ = spin * turn * far + 2 * turn * speed + a.second + b.second;
        if (!(curvature_ * horizon_ * horizon_ > tolerance::much_curved * std::fabs(now_.value))) return;
        const double third = spin * (spin * turn * far + 3 * turn * speed) + a.third + b.third;
        const double bent = reach_along(f.b, -b.now) + reach_along(f.a, a.now) -
                            dot(cross(axis.spin, drift_), f.b.pivot) - 2 * dot(drift_, f.velocity);
        curvature_ = std::min(curvature_, std::max(0.0, bent) + third * horizon_);
    }

    double horizon() const { return horizon_; }
    double curvature() const { return curvature_; }
    Piece now() const { return now_; }
    Piece piece(double h) const
    {
        const Piece a = leading(f_.a, axis_.normal, shift_a_, h);
        const Piece b = trailing(f_.b, axis_.normal, shift_b_, h);
        return {(b.value - a.value) - f_.margin, slope_ + (b.slope - a.slope)};
    }
    double at(double h, Piece p) const { return p.value + h * p.slope - 0.5 * curvature_ * h * h; }
    /// Where the parabola through this piece falls to `level`; never before phi itself does.
    double reaches(double level, Piece p) const
    {
        const double above = std::max(0.0, p.value - level);
        const double root = std::sqrt(p.slope * p.slope + 2 * curvature_ * above);
        if (p.slope > 0) return curvature_ > 0 ? (p.slope + root) / curvature_ : infinity;
        return root - p.slope > 0 ? 2 * above / (root - p.slope) : infinity;
    }

    struct Last {
        double h, value; // phi(h) or, beyond the last h with phi >= level, a little less than the level
    };
    /// Newton's method from outside: the largest h, or a little more, with phi(h) >= level.
    Last last(double level) const
    {
        double x = std::min(horizon_, reaches(level, now_));
        for (int i = 0;; ++i) {
            const Piece p = piece(x);
            const double value = at(x, p);
            if (value >= level || i == newton_rounds) return {x, value};
            const double next = reaches(level, p);
            if (!(next < x)) return {x, value};
            x = next;
        }
    }

private:
    const Facing<Part>& f_;
    const Axis& axis_;
    V3 shift_a_, shift_b_, drift_;
    double slope_;
    Piece now_;
    double horizon_, curvature_ = 0;
};

} // namespace

template <class Part> Step safe_step(const Facing<Part>& f, const Axis& axis, double horizon)
{
    const Bound<Part> bound(f, axis, horizon);
    Step step{bound.now().value, 0, 0};
    if (!(step.gap > 0)) return step;
    const auto [x, left] = bound.last(0);
    // The chord lies below a concave function.
    step.length = left >= 0 ? x : x * (step.gap / (step.gap - left)) * tolerance::step_shrink;
    step.residual = bound.curvature() * step.length * step.length;
    return step;
}

template <class Part> double rising_step(const Facing<Part>& f, const Axis& axis, double horizon)
{
    const Bound<Part> bound(f, axis, horizon);
    const double level = bound.now().value;
    const auto [x, value] = bound.last(level);
    if (x >= horizon && value >= level) return horizon;
    const double half = 0.5 * x; // the top of a parabola; further on the bound falls again
    return bound.at(half, bound.piece(half)) >= level ? half : 0;
}

template <class Part> double closing_speed(const Facing<Part>& f, const Axis& axis)
{
    return -Bound<Part>(f, axis, 0).now().slope;
}

double closing_rate(const Facing<Core>& f, V3 axis)
{
    return norm(cross(axis, f.a.rate)) * f.a.reach + norm(cross(axis, f.b.rate)) * f.b.reach -
           dot(axis, f.velocity);
}

template Step safe_step(const Facing<Core>&, const Axis&, double);
template Step safe_step(const Facing<Border>&, const Axis&, double);
template double closing_speed(const Facing<Core>&, const Axis&);
template double closing_speed(const Facing<Border>&, const Axis&);
template double rising_step(const Facing<Core>&, const Axis&, double);
template double rising_step(const Facing<Border>&, const Axis&, double);

} // namespace brink
