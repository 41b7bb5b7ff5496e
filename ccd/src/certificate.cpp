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

/// The point of a core that lies farthest along d.
V3 extreme_point(const Core& core, V3 d)
{
    if (!is_simple(core)) return farthest(core, d).point;
    V3 best = corner(core, 0);
    double most = dot(d, best);
    for (int k = 1; k < core.count; ++k) {
        const V3 point = corner(core, k);
        const double value = dot(d, point);
        if (!(value > most)) continue;
        best = point;
        most = value;
    }
    return best;
}

/// How a body shows along the turning axis: its extreme point's line. `side` is +1 for A, whose largest value
/// counts, and -1 for B, whose smallest does.
Piece extreme(const Turning& body, V3 axis, V3 shift, double h, double side)
{
    if (body.core == nullptr) return {body.level, 0};
    const V3 point = extreme_point(*body.core, side * (axis + h * shift));
    return {dot(axis, point), dot(shift, point)};
}

/// Bounds the second derivative of n . x for a point x of the body while the axis n turns with `spin`.
double bend(const Turning& body, V3 spin, V3 axis)
{
    const V3 relative = body.rate - spin;
    const double rate = norm(relative);
    const double across = spin == V3{} ? norm(cross(axis, relative)) : rate;
    return body.reach * (norm(cross(body.rate, spin)) + across * rate);
}

/// phi(h) = value + slope h - curvature h^2 / 2 <= gap(t + h) for h in [0, horizon]: every pair of points at
/// once, because the extreme points are those of an axis that moves linearly. phi is concave. Proof:
/// numerics.md.
class Bound {
public:
    /// The axis turns with the constant rate `spin`.
    Bound(const Facing& f, V3 spin, double horizon)
        : f_(f), shift_a_(cross(f.axis, f.a.rate - spin)), shift_b_(cross(f.axis, f.b.rate - spin))
    {
        const V3 drift = cross(spin, f.axis);
        slope_ = dot(f.axis, f.velocity) + dot(drift, f.offset);
        start_ = f.gap - difference(0).value;
        const Piece now = piece(0);
        horizon_ = now.slope < 0 && f.gap > 0 ? std::min(horizon, f.gap / -now.slope) : horizon;
        const double far = std::max(norm(f.offset), norm(f.offset + horizon_ * f.velocity));
        const double turn = norm(drift);
        curvature_ = norm(spin) * turn * far + 2 * turn * norm(f.velocity) + bend(f.a, spin, f.axis) +
                     bend(f.b, spin, f.axis);
    }

    double horizon() const { return horizon_; }
    Piece piece(double h) const
    {
        const Piece d = difference(h);
        return {start_ + d.value, slope_ + d.slope};
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
    /// Newton's method from outside: the largest h, or a little more, with phi(h) >= level.
    double last(double level) const
    {
        double x = horizon_;
        for (int i = 0; i < newton_rounds; ++i) {
            const Piece p = piece(x);
            if (at(x, p) >= level) return x;
            const double next = reaches(level, p);
            if (!(next < x)) return x;
            x = next;
        }
        return x;
    }

private:
    Piece difference(double h) const
    {
        const Piece a = extreme(f_.a, f_.axis, shift_a_, h, 1), b = extreme(f_.b, f_.axis, shift_b_, h, -1);
        return {b.value - a.value, b.slope - a.slope};
    }

    const Facing& f_;
    V3 shift_a_, shift_b_;
    double slope_ = 0, start_ = 0, horizon_ = 0, curvature_ = 0;
};

double safe(const Facing& f, V3 spin, double horizon)
{
    const Bound bound(f, spin, horizon);
    const double x = bound.last(0), left = bound.at(x, bound.piece(x));
    if (left >= 0) return x;
    return x * (f.gap / (f.gap - left)) * tolerance::step_shrink; // the chord lies below a concave function
}

double rising(const Facing& f, V3 spin, double horizon)
{
    const Bound bound(f, spin, horizon);
    const double x = bound.last(f.gap);
    if (x >= horizon && bound.at(x, bound.piece(x)) >= f.gap) return horizon;
    const double half = 0.5 * x; // the top of a parabola; further on the bound falls again
    return bound.at(half, bound.piece(half)) >= f.gap ? half : 0;
}

/// A world-fixed axis falls at most this fast, whatever the points.
double first_order(const Facing& f, double horizon)
{
    const double rate = norm(cross(f.axis, f.a.rate)) * f.a.reach +
                        norm(cross(f.axis, f.b.rate)) * f.b.reach - dot(f.axis, f.velocity);
    return rate * horizon <= f.gap ? horizon : f.gap / rate * tolerance::step_shrink;
}

/// The edges of a body that lie in its supporting plane: one, or some of a face's. Without any, a zero stands
/// for a corner.
struct Edges {
    int count = 0;
    V3 direction[3]; // unit
};

Edges edges_across(const Core& core, V3 axis, double side)
{
    int nearest = 0;
    for (int k = 1; k < core.count; ++k)
        if (side * dot(axis, corner(core, k)) > side * dot(axis, corner(core, nearest))) nearest = k;
    Edges edges;
    const auto add = [&](V3 along) {
        const double length = norm(along);
        if (length > 0 && std::fabs(dot(axis, along)) <= tolerance::flat_edge * length && edges.count < 3)
            edges.direction[edges.count++] = (1 / length) * along;
    };
    for (int k = 0; k < core.count; ++k)
        add(corner(core, k) - corner(core, nearest));
    if (core.count == 3 && edges.count == 2)
        add(corner(core, (nearest + 1) % 3) - corner(core, (nearest + 2) % 3));
    return edges;
}

/// The rate at which the common normal of two edges really turns, or of an edge and a corner (a zero): a
/// normal at right angles to edge e of a body that turns with w changes by eta with eta . e = -n . (w x e).
V3 following(const Facing& f, V3 e, V3 g)
{
    const double along_e = -dot(f.axis, cross(f.a.rate, e)), along_g = -dot(f.axis, cross(f.b.rate, g));
    const double cosine = dot(e, g), rest = 1 - cosine * cosine;
    if (rest < tolerance::nearly_parallel) return {};
    const V3 eta = ((along_e - cosine * along_g) / rest) * e + ((along_g - cosine * along_e) / rest) * g;
    return cross(f.axis, eta);
}

/// The best step over the axes worth turning: at rest, glued to A, glued to B, and following the edges that
/// touch; those of faces too where nothing else gets away from the spot. A plane's normal stays with it. Any
/// rate is valid; the right one makes the steps converge.
template <class Step> double best(const Facing& f, double horizon, Step step)
{
    if (f.b.core == nullptr) return step(f, f.b.rate, horizon);
    double h = step(f, V3{}, horizon);
    const auto better = [&](V3 spin) {
        if (!(spin == V3{}) && h < horizon) h = std::max(h, step(f, spin, horizon));
    };
    better(f.a.rate);
    better(f.b.rate);
    const Edges of_a = edges_across(*f.a.core, f.axis, 1), of_b = edges_across(*f.b.core, f.axis, -1);
    const bool faces = of_a.count > 1 || of_b.count > 1;
    if (faces && h > tolerance::standstill * horizon) return h;
    for (int i = 0; i < std::max(1, of_a.count); ++i)
        for (int k = 0; k < std::max(1, of_b.count); ++k)
            better(following(f, of_a.direction[i], of_b.direction[k]));
    return h;
}

} // namespace

double safe_step(const Facing& f, double horizon)
{
    const double simple = f.b.core != nullptr ? first_order(f, horizon) : 0;
    return simple >= horizon ? horizon : std::max(simple, best(f, horizon, safe));
}

double rising_step(const Facing& f, double horizon) { return best(f, horizon, rising); }

} // namespace brink
