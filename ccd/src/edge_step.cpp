// SPDX-License-Identifier: BSD-3-Clause
#include "edge_step.h"

#include "arches.h"
#include "flattest_edge.h"
#include "tolerance.h"

namespace brink {

namespace {

/// A body's points x by their part of the gap, `across` . (along x (x - from)): both edges taken along by
/// their bodies, the product turns with the difference of the rates.
class Strands {
public:
    Strands(const Posed<Core>& body, V3 from, V3 along, V3 across, V3 other_rate, double side)
        : core_(body.part),
          from_(from),
          along_(along),
          turned_{across, cross(other_rate - body.rate, across)},
          side_(side)
    {
        const double other = norm(other_rate), both = body.angle + other;
        alone_ = other == 0 || body.angle == 0;
        rate_ = body.rate - other_rate;
        const double rate = norm(rate_);
        if (alone_) ring_ = Ring(rate > 0 ? (1 / rate) * rate_ : V3{});
        bend_ = alone_ ? norm(turned_.shift) : both * both * norm(across);
    }
    Arc extreme(double h) const
    {
        if (!is_polytope(core_)) return on_round(h);
        Arc best;
        double highest = -infinity;
        for (int k = 0; k < core_.count; ++k) {
            const V3 p = corner(core_, k), z = cross(p - from_, along_);
            const Arc arc{turned_.along(z), bend_ * norm(alone_ ? cross(rate_, z) : z), p};
            const double height = side_ * arc.line.at(h) + 0.5 * arc.bend * h * h;
            if (height > highest) highest = height, best = arc;
        }
        return best;
    }

private:
    Arc on_round(double h) const
    {
        const V3 u = side_ * turned_.at(h);
        const V3 p = ring_.farthest(core_, from_, cross(along_, u), 0.5 * bend_ * h * h,
                                    [&](V3 e) { return cross(along_, alone_ ? cross(e, rate_) : e); });
        const V3 z = cross(p - from_, along_);
        return {turned_.along(z), bend_ * ring_.length(alone_ ? cross(rate_, z) : z), p};
    }

    const Core& core_;
    V3 from_, along_;
    Turned turned_;
    double side_, bend_ = 0;
    bool alone_ = false; // of both bodies one does not turn
    V3 rate_;
    Ring ring_{along_};
};

/// By one line of each.
Step across(const Facing<Core>& f, const FlatEdge& a, const FlatEdge& b, V3 normal, double horizon)
{
    const V3 product = cross(a.along, b.along);
    const double sine = norm(product);
    if (!(sine > tolerance::skew)) return {};
    const V3 e = a.along, g = ((dot(product, normal) < 0 ? -1 : 1) / sine) * b.along, m = cross(e, g);
    const auto [s, t] = nearest_places(a, b);
    const V3 p = a.top + s * e, q = b.top + t * b.along;
    const V3 on_a = p - f.a.pivot, on_b = q - f.b.pivot, way = q - p;
    const double rates = f.a.angle + f.b.angle, stretch = norm(g);
    const V3 turning = cross(cross(f.a.rate, e), g) + cross(e, cross(f.b.rate, g));
    const V3 parting = f.velocity + cross(f.b.rate, on_b) - cross(f.a.rate, on_a);
    const double speeding = f.a.angle * norm(cross(f.a.rate, on_a)) + f.b.angle * norm(cross(f.b.rate, on_b));
    const double speed = norm(parting) + horizon * speeding;
    const double far = norm(way) + horizon * speed;
    const double bend = stretch * (speeding + rates * (2 * speed + rates * far)) +
                        f.margin * (rates * rates * stretch + norm_squared(turning));
    const double rounding =
        tolerance::edge_slack * stretch * (norm(f.b.pivot) + norm(p) + norm(q) + f.a.reach + f.b.reach);
    const Line rest{dot(m, way) - f.margin - rounding,
                    dot(turning, way) + dot(m, parting) - f.margin * dot(m, turning)};
    const Strands of_a(f.a, p, e, g, f.b.rate, 1), of_b(f.b, q, -g, e, f.a.rate, -1);
    const Arches arches(of_a, of_b, rest, bend);
    const double gap = arches.now();
    if (!(gap > 0)) return {gap, 0, 0};
    const auto last = arches.last(0, horizon);
    return {gap, last.h, last.bend * last.h * last.h};
}

} // namespace

Step edge_step(const Facing<Core>& f, V3 normal, double horizon)
{
    const FlatLines of_a = flat_lines(f.a.part, normal), of_b = flat_lines(f.b.part, -normal);
    Step best;
    for (int i = 0; i < of_a.count; ++i)
        for (int k = 0; k < of_b.count; ++k) {
            const Step step = across(f, of_a.line[i], of_b.line[k], normal, horizon);
            if (step.length > best.length) best = step;
        }
    return best;
}

} // namespace brink
