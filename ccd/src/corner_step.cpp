// SPDX-License-Identifier: BSD-3-Clause
#include "corner_step.h"

#include "arches.h"
#include "support.h"
#include "tolerance.h"

#include <algorithm>

namespace brink {

namespace {

/// The points of a body along an axis n + h shift, each with its own bend; of what has too many or turns
/// otherwise than the axis, the whole.
class Arcs {
public:
    Arcs(const Posed<Core>& body, const TurningAxis& axis, double side)
        : body_(body),
          apart_(body.rate - axis.spin),
          turned_{axis.normal, cross(axis.normal, apart_)},
          twist_(norm(cross(body.rate, axis.spin))),
          still_(axis.spin == V3{} || body.rate == V3{}),
          apart_rate_(norm(apart_)),
          shift_(norm(turned_.shift)),
          side_(side)
    {
    }
    /// The one that reaches farthest at h, its bend added: along the axis, or against it where `side` is -1.
    Arc extreme(double h) const
    {
        const Core& c = body_.part;
        if (is_polytope(c) && c.count <= tolerance::most_corners) return corner_at(h);
        if (is_polytope(c) || !still_ || !(apart_rate_ > 0)) {
            const V3 p = farthest(c, side_ * turned_.at(h)).point;
            return {turned_.along(p, body_.pivot), whole(), p};
        }
        const Ring ring((1 / apart_rate_) * apart_);
        const double bend = shift_ * apart_rate_;
        const V3 p =
            ring.farthest(c, body_.pivot, side_ * turned_.at(h), 0.5 * h * h * bend, [](V3 e) { return e; });
        return {turned_.along(p, body_.pivot), bend * ring.length(p - body_.pivot), p};
    }

private:
    Arc corner_at(double h) const
    {
        const Core& c = body_.part;
        Arc best;
        double highest = -infinity;
        for (int k = 0; k < c.count; ++k) {
            const V3 p = corner(c, k);
            const Arc arc{turned_.along(p, body_.pivot), bend(p - body_.pivot), p};
            const double height = side_ * arc.line.at(h) + 0.5 * arc.bend * h * h;
            if (height > highest) highest = height, best = arc;
        }
        return best;
    }
    double whole() const
    {
        return body_.reach * (still_ ? shift_ * apart_rate_ : twist_ + apart_rate_ * apart_rate_);
    }
    double bend(V3 from_pivot) const
    {
        return still_ ? shift_ * norm(cross(apart_, from_pivot))
                      : norm(from_pivot) * (twist_ + apart_rate_ * apart_rate_);
    }

    const Posed<Core>& body_;
    V3 apart_;
    Turned turned_;
    double twist_;
    bool still_; // of body and axis one does not turn
    double apart_rate_, shift_, side_;
};

/// A plane goes with its own normal.
class Straight {
public:
    Straight(const Posed<Border>& body, const TurningAxis& axis, double side)
        : level_(body, axis.normal, {}, side)
    {
    }
    Arc extreme(double) const { return {level_.now(), 0, {}}; }

private:
    Level level_;
};

template <class Part> using ArcsOf = std::conditional_t<std::is_same_v<Part, Core>, Arcs, Straight>;

/// Does with the arches of an axis what is to be done.
template <class Part, class Do>
auto with_arches(const Facing<Part>& f, const TurningAxis& axis, double horizon, Do go)
{
    const V3 drift = cross(axis.spin, axis.normal);
    const double spin = norm(axis.spin), turn = norm(drift), speed = norm(f.velocity);
    const V3 apart = f.b.pivot - f.a.pivot;
    const double far = std::max(norm(apart), norm(apart + horizon * f.velocity));
    const Line rest{-f.margin, dot(axis.normal, f.velocity) + dot(drift, apart)};
    const Arcs a(f.a, axis, 1);
    const ArcsOf<Part> b(f.b, axis, -1);
    return go(Arches(a, b, rest, spin * turn * far + 2 * turn * speed));
}

template <class Part> Blocked blocked(const Facing<Part>& f, const TurningAxis& axis, double horizon)
{
    return with_arches(f, axis, horizon, [&](const auto& arches) -> Blocked {
        const double gap = arches.now();
        const auto last = arches.last(0, horizon);
        if (!(gap > 0)) return {{gap, 0, 0}, last.on_a, last.on_b};
        return {{gap, last.h, last.bend * last.h * last.h}, last.on_a, last.on_b};
    });
}

/// The highest that a point of a body comes along a unit vector from its pivot, however often it turns.
double highest_on_circles(const Posed<Core>& body, V3 n)
{
    if (!(body.angle > 0)) return highest(body.part, n) - dot(n, body.pivot);
    const V3 axis = (1 / body.angle) * body.rate;
    const V3 along = dot(n, axis) * axis;
    const double across = norm(cross(axis, n));
    const Core& c = body.part;
    double most = -infinity;
    if (is_polytope(c)) {
        for (int k = 0; k < c.count; ++k) {
            const V3 p = corner(c, k) - body.pivot;
            most = std::max(most, dot(along, p) + across * norm(cross(axis, p)));
        }
        return most;
    }
    const Ring ring(axis);
    const V3 p = ring.farthest(c, body.pivot, along, across, [](V3 e) { return e; }) - body.pivot;
    return dot(along, p) + across * ring.length(p);
}

} // namespace

template <class Part> Facing<Part> about_one_pivot(const Facing<Part>& f)
{
    const double apart = norm(f.b.pivot - f.a.pivot);
    const auto seen_from = [apart](auto body, V3 pivot) {
        return decltype(body){body.part, pivot, body.reach + apart, body.rate, body.angle};
    };
    if (f.b.angle == 0) return {f.a, seen_from(f.b, f.a.pivot), f.velocity, f.margin};
    if (f.a.angle == 0) return {seen_from(f.a, f.b.pivot), f.b, f.velocity, f.margin};
    return f;
}

template <class Part> Step corner_step(const Facing<Part>& f, const TurningAxis& axis, double horizon)
{
    return blocked(about_one_pivot(f), axis, horizon).step;
}

Blocked blocked_step(const Facing<Core>& f, const TurningAxis& axis, double horizon)
{
    return blocked(f, axis, horizon);
}

Step whirl_step(const Facing<Core>& f, V3 normal, double horizon)
{
    const double gap = dot(normal, f.b.pivot - f.a.pivot) - f.margin - highest_on_circles(f.a, normal) -
                       highest_on_circles(f.b, -normal);
    if (!(gap > 0)) return {};
    const double rate = dot(normal, f.velocity);
    if (rate >= 0) return {gap, horizon, 0};
    return {gap, std::min(horizon, gap / -rate * tolerance::step_shrink), 0};
}

template <class Part> double corner_rise(const Facing<Part>& f, const TurningAxis& axis, double horizon)
{
    return with_arches(about_one_pivot(f), axis, horizon,
                       [&](const auto& arches) { return arches.last(arches.now(), horizon).h; });
}

template Facing<Core> about_one_pivot(const Facing<Core>&);
template Facing<Border> about_one_pivot(const Facing<Border>&);
template Step corner_step(const Facing<Core>&, const TurningAxis&, double);
template Step corner_step(const Facing<Border>&, const TurningAxis&, double);
template double corner_rise(const Facing<Core>&, const TurningAxis&, double);
template double corner_rise(const Facing<Border>&, const TurningAxis&, double);

} // namespace brink
