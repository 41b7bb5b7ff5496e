// SPDX-License-Identifier: BSD-3-Clause
#include "corner_step.h"

#include "falling.h"
#include "shadow.h"
#include "support.h"
#include "tolerance.h"

#include <algorithm>

namespace brink {

namespace {

constexpr int newton_rounds = 16;

/// A height along the axis as a line in h, and what it may bend by: off by bend h^2 / 2 at most.
struct Arc {
    Line line;
    double bend = 0;
};

/// The corners of a body along an axis n + h shift, each with its own bend; of what has none, the whole.
class Arcs {
public:
    Arcs(const Posed<Core>& body, const TurningAxis& axis, double side)
        : body_(body),
          apart_(body.rate - axis.spin),
          turned_{axis.normal, cross(axis.normal, apart_)},
          still_(axis.spin == V3{}),
          turn_(norm(cross(body.rate, axis.spin)) + norm_squared(apart_)),
          shift_(norm(turned_.shift)),
          side_(side)
    {
    }
    /// The one that reaches farthest at h, its bend added: along the axis, or against it where `side` is -1.
    Arc extreme(double h) const
    {
        const Core& c = body_.part;
        if (!is_polytope(c) || c.count > tolerance::most_corners)
            return {Shadow(body_, turned_.axis, turned_.shift, side_).extreme(h), whole()};
        Arc best;
        double highest = -infinity;
        for (int k = 0; k < c.count; ++k) {
            const V3 p = corner(c, k);
            const Arc arc{turned_.along(p, body_.pivot), bend(p - body_.pivot)};
            const double height = side_ * arc.line.at(h) + 0.5 * arc.bend * h * h;
            if (height > highest) highest = height, best = arc;
        }
        return best;
    }

private:
    double whole() const { return body_.reach * (still_ ? shift_ * body_.angle : turn_); }
    double bend(V3 from_pivot) const
    {
        return still_ ? shift_ * norm(cross(body_.rate, from_pivot)) : norm(from_pivot) * turn_;
    }

    const Posed<Core>& body_;
    V3 apart_;
    Turned turned_;
    bool still_;
    double turn_, shift_, side_;
};

/// A plane goes with its own normal.
class Straight {
public:
    Straight(const Posed<Border>& body, const TurningAxis& axis, double side)
        : level_(body, axis.normal, {}, side)
    {
    }
    Arc extreme(double) const { return {level_.now(), 0}; }

private:
    Level level_;
};

template <class Part> using ArcsOf = std::conditional_t<std::is_same_v<Part, Core>, Arcs, Straight>;

} // namespace

template <class Part> Step corner_step(const Facing<Part>& f, const TurningAxis& axis, double horizon)
{
    const V3 drift = cross(axis.spin, axis.normal);
    const double spin = norm(axis.spin), turn = norm(drift), speed = norm(f.velocity);
    const double far = std::max(norm(f.b.pivot), norm(f.b.pivot + horizon * f.velocity));
    const Arcs a(f.a, axis, 1);
    const ArcsOf<Part> b(f.b, axis, -1);
    const Line rest{-f.margin, dot(axis.normal, f.velocity) + dot(drift, f.b.pivot)};
    const auto lowest = [&](double h) -> Arc {
        const Arc on_a = a.extreme(h), on_b = b.extreme(h);
        return {(on_b.line - on_a.line) + rest, spin * turn * far + 2 * turn * speed + on_a.bend + on_b.bend};
    };
    Arc arc = lowest(0);
    Step step{arc.line.value, 0, 0};
    if (!(step.gap > 0)) return step;
    double x = horizon;
    for (int i = 0; i < newton_rounds; ++i) {
        arc = lowest(x);
        const double left = arc.line.at(x) - 0.5 * arc.bend * x * x;
        if (left >= 0) {
            step.length = x;
            step.residual = arc.bend * x * x;
            return step;
        }
        x = std::min(x, falls(arc.line.value, arc.line.slope, arc.bend) * tolerance::step_shrink);
    }
    return step;
}

template Step corner_step(const Facing<Core>&, const TurningAxis&, double);
template Step corner_step(const Facing<Border>&, const TurningAxis&, double);

} // namespace brink
