// SPDX-License-Identifier: BSD-3-Clause
#include "certificate.h"

#include "support.h"
#include "tolerance.h"

#include <algorithm>
#include <type_traits>

namespace brink {

namespace {

constexpr int newton_rounds = 8;

/// The points that support the turning axis at some h, as a line in h.
struct Piece {
    double value, slope;
};

/// How a body shows along an axis n + h shift, for all h: where its extreme points lie. Of a few corners, and
/// of a box, no more is needed than their lines.
class Shadow {
public:
    Shadow(const Posed<Core>& body, V3 axis, V3 shift) : body_(body), axis_(axis), shift_(shift)
    {
        const Core& c = body.part;
        const V3 h = c.half_extents, axes[3] = {c.axes.x, c.axes.y, c.axes.z};
        if (c.kind <= Core::Kind::triangle) {
            for (int k = 0; k < c.count; ++k)
                line_[k] = {dot(axis, c.points[k]), dot(shift, c.points[k] - body.pivot)};
        } else if (c.kind == Core::Kind::box) {
            middle_ = {dot(axis, c.centre), dot(shift, c.centre - body.pivot)};
            const double half[3] = {h.x, h.y, h.z};
            for (int k = 0; k < 3; ++k)
                line_[k] = {half[k] * dot(axis, axes[k]), half[k] * dot(shift, axes[k])};
        }
    }
    /// The line of the point that lies farthest along the axis, or against it where `side` is -1.
    [[gnu::always_inline]] Piece extreme(double h, double side) const
    {
        const Core& c = body_.part;
        if (c.kind == Core::Kind::box) {
            Piece p = middle_;
            for (const Piece& l : line_) {
                const double sign = l.value + h * l.slope > 0 ? side : -side;
                p = {p.value + sign * l.value, p.slope + sign * l.slope};
            }
            return p;
        }
        if (c.kind <= Core::Kind::triangle) {
            Piece best = line_[0];
            for (int k = 1; k < c.count; ++k)
                if (side * (line_[k].value + h * line_[k].slope) > side * (best.value + h * best.slope))
                    best = line_[k];
            return best;
        }
        const V3 p = farthest(c, side * (axis_ + h * shift_)).point;
        return {dot(axis_, p), dot(shift_, p - body_.pivot)};
    }

private:
    const Posed<Core>& body_;
    V3 axis_, shift_;
    Piece middle_{}, line_[3]{};
};

/// A plane has one possible axis, its own normal, which stays with it.
class Level {
public:
    Level(const Posed<Border>& body, V3 axis, V3)
        : value_(dot(axis, body.part.normal) < 0 ? -body.part.offset : body.part.offset)
    {
    }
    Piece extreme(double, double) const { return {value_, 0}; }

private:
    double value_;
};

template <class Part> using ShadowOf = std::conditional_t<std::is_same_v<Part, Core>, Shadow, Level>;

/// The largest x . q over a body's points about its pivot.
double reach_along(const Posed<Core>& body, V3 q) { return highest(body.part, q) - dot(q, body.pivot); }
double reach_along(const Posed<Border>&, V3) { return 0; }

/// What one body adds to the bounds of the second and third derivative of n . x while n turns.
struct Bend {
    double second = 0, third = 0;
    V3 now; // the second derivative of n . x now is x . now
};

template <class Part>
[[gnu::always_inline]] inline Bend bend(const Posed<Part>& body, const TurningAxis& n, double spin)
{
    const V3 relative = body.rate - n.spin;
    if (relative == V3{}) return {}; // the axis is glued to it
    if (spin == 0) {
        const V3 m = cross(n.normal, body.rate);
        const double across = norm(m) * body.angle;
        return {body.reach * across, body.reach * across * body.angle, cross(m, body.rate)};
    }
    const V3 u = cross(body.rate, n.spin);
    const double rate = norm(relative), turn = norm(u);
    return {body.reach * (turn + rate * rate),
            body.reach * (rate * rate * rate + 3 * rate * turn + spin * turn),
            cross(n.normal, u) + cross(relative, cross(relative, n.normal))};
}

/// phi(h) = value + slope h - curvature h^2 / 2 <= gap(t + h) for h in [0, horizon]: every pair of points at
/// once, because the extreme points are those of an axis that moves linearly. phi is concave. Proof:
/// numerics.md.
template <class Part> class Bound {
public:
    Bound(const Facing<Part>& f, const TurningAxis& axis, double horizon)
        : f_(f),
          axis_(axis),
          a_(f.a, axis.normal, cross(axis.normal, f.a.rate - axis.spin)),
          b_(f.b, axis.normal, cross(axis.normal, f.b.rate - axis.spin)),
          drift_(cross(axis.spin, axis.normal)),
          slope_(dot(axis.normal, f.velocity) + dot(drift_, f.b.pivot)),
          now_(piece(0)),
          horizon_(horizon)
    {
        // Past the root of its tangent a concave function is negative.
        if (now_.slope < 0 && now_.value > 0) horizon_ = std::min(horizon, now_.value / -now_.slope);
        bend_towards();
    }

    double curvature() const { return curvature_; }
    Piece now() const { return now_; }
    Piece piece(double h) const
    {
        const Piece a = a_.extreme(h, 1), b = b_.extreme(h, -1);
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
    void bend_towards()
    {
        const double spin = norm(axis_.spin);
        const Bend a = bend(f_.a, axis_, spin), b = bend(f_.b, axis_, spin);
        curvature_ = a.second + b.second;
        double third = a.third + b.third;
        if (spin > 0) {
            const double far = std::max(norm(f_.b.pivot), norm(f_.b.pivot + horizon_ * f_.velocity));
            const double turn = norm(drift_), speed = norm(f_.velocity);
            curvature_ += spin * turn * far + 2 * turn * speed;
            third += spin * (spin * turn * far + 3 * turn * speed);
        }
        if (!(curvature_ * horizon_ * horizon_ > tolerance::much_curved * std::fabs(now_.value))) return;
        const double bent = reach_along(f_.b, -b.now) + reach_along(f_.a, a.now) -
                            dot(cross(axis_.spin, drift_), f_.b.pivot) - 2 * dot(drift_, f_.velocity);
        curvature_ = std::min(curvature_, std::max(0.0, bent) + third * horizon_);
    }

    const Facing<Part>& f_;
    const TurningAxis& axis_;
    Shadow a_;
    ShadowOf<Part> b_;
    V3 drift_;
    double slope_;
    Piece now_;
    double horizon_, curvature_ = 0;
};

} // namespace

template <class Part> Step safe_step(const Facing<Part>& f, const TurningAxis& axis, double horizon)
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

template <class Part> double rising_step(const Facing<Part>& f, const TurningAxis& axis, double horizon)
{
    const Bound<Part> bound(f, axis, horizon);
    const double level = bound.now().value;
    const auto [x, value] = bound.last(level);
    if (x >= horizon && value >= level) return horizon;
    const double half = 0.5 * x; // the top of a parabola; further on the bound falls again
    return bound.at(half, bound.piece(half)) >= level ? half : 0;
}

template <class Part> double closing_speed(const Facing<Part>& f, const TurningAxis& axis)
{
    const Piece a = Shadow(f.a, axis.normal, cross(axis.normal, f.a.rate - axis.spin)).extreme(0, 1);
    const Piece b = ShadowOf<Part>(f.b, axis.normal, cross(axis.normal, f.b.rate - axis.spin)).extreme(0, -1);
    const V3 drift = cross(axis.spin, axis.normal);
    return (a.slope - b.slope) - (dot(axis.normal, f.velocity) + dot(drift, f.b.pivot));
}

double closing_rate(const Facing<Core>& f, V3 axis)
{
    return norm(cross(axis, f.a.rate)) * f.a.reach + norm(cross(axis, f.b.rate)) * f.b.reach -
           dot(axis, f.velocity);
}

template Step safe_step(const Facing<Core>&, const TurningAxis&, double);
template Step safe_step(const Facing<Border>&, const TurningAxis&, double);
template double closing_speed(const Facing<Core>&, const TurningAxis&);
template double closing_speed(const Facing<Border>&, const TurningAxis&);
template double rising_step(const Facing<Core>&, const TurningAxis&, double);
template double rising_step(const Facing<Border>&, const TurningAxis&, double);

} // namespace brink
