// SPDX-License-Identifier: BSD-3-Clause
#include "quick_walk.h"

#include "reference.h"

#include <algorithm>

namespace brink::support {
namespace {

using Kind = QuickBody::Kind;

/// at + rate h - bend h^2 / 2.
struct Arc {
    double at = 0, rate = 0, bend = 0;
    double after(double h) const { return at + h * (rate - h * bend / 2); }
    /// Where it comes down to 0, from above; `most` if not before.
    double root(double most) const
    {
        if (at <= 0) return 0;
        const double under = rate * rate + 2 * bend * at;
        const double below = std::sqrt(under) - rate;
        return below * most <= 2 * at ? most : 2 * at / below;
    }
};

Arc operator+(const Arc& x, const Arc& y) { return {x.at + y.at, x.rate + y.rate, x.bend + y.bend}; }

/// How one body's points move against an axis that starts as n and turns: along n from `base` they change by
/// `turning`, and no faster than `bend` times how far they are from it does that change.
struct Side {
    const QuickPlace* place = nullptr;
    Quick3 n, turning;
    double bend = 0;
    bool by_swing = false; // the axis is at rest: points count by how far they are from the axis of turning
    bool turns = true;
    Quick3 base;       // the pivot; of a body that does not turn its nearest point, for any will do
    double ground = 0; // of ground: all there is

    double far(std::size_t i) const
    {
        if (bend == 0) return 0;
        if (turns) return by_swing ? place->body->swing[i] : place->body->reach[i];
        if (!place->points.empty()) return norm(place->points[i] - base) * (1 + 0x1p-40);
        return place->body->reach[i] + norm(base) * (1 + 0x1p-40);
    }

    /// That of the point which is least after h.
    Arc least(double h) const
    {
        const QuickBody& body = *place->body;
        if (body.kind == Kind::ground) return {ground, 0, 0};
        Arc best;
        double lowest = infinity;
        const bool parts = place->points.empty();
        const std::size_t count = parts ? body.reach.size() : place->points.size();
        for (std::size_t i = 0; i < count; ++i) {
            const Quick3 p = (parts ? place->least_of_part(i, n + h * turning) : place->points[i]) - base;
            const Arc arc{dot(n, p), dot(turning, p), bend * far(i)};
            const double here = arc.after(h);
            if (here >= lowest) continue;
            lowest = here;
            best = arc;
        }
        return best;
    }
};

/// Against an axis that turns by `om`: the separation over all points is at least the sum of three arcs, the
/// least of which (as a sum of concave functions) is concave in h. f = n . (D + beta - alpha) has
///   f'(0) = n . V + eta . D + beta . m_B - alpha . m_A,  eta = om x n,  d = w - om,  m = n x d,  u = w x om,
///   |f''| <= |om| |eta| |D| + 2 |eta| |V| + |beta| (|u_B| + k_B |d_B|) + |alpha| (|u_A| + k_A |d_A|),
/// k = |d|, or |m| for om = 0 (then with the distance from the axis of turning in the place of |beta|): in
/// the frame that turns with om, x' = d x x, and n . (d x (d x x)) = (n x d) . (d x x).
class Certificate {
public:
    Certificate(const QuickLook& at, const Quick3& v, const Quick3& om, double most, double level)
        : most_(std::abs(most))
    {
        const Quick3& n = at.gap.normal;
        const Quick3 eta = cross(om, n);
        const double sign = most < 0 ? -1 : 1;
        a_ = side(at.a, -n, om, sign, at.gap.point_a);
        b_ = side(at.b, n, om, sign, at.gap.point_b);
        const Quick3 d = at.b.pivot - at.a.pivot + (b_.base - a_.base);
        const double turn = norm(eta);
        const double far = std::max(norm(d), norm(d + most * v));
        base_ = {dot(n, d) - level, sign * (dot(n, v) + dot(eta, d)),
                 (norm(om) * turn * far + 2 * turn * norm(v)) * (1 + 0x1p-40)};
    }

    /// How far it holds: by the tangents of a concave function, from outside, then by a chord.
    double holds() const
    {
        double h = most_;
        const double start = sum(0).at;
        if (!(start > 0)) return 0;
        for (int i = 0; i < 5; ++i) {
            const Arc arc = sum(h);
            const double here = arc.after(h);
            if (here >= 0) return h;
            const double next = arc.root(h);
            if (!(next < h * (1 - 0x1p-20))) return h * start / (start - here) * (1 - 0x1p-50);
            h = next;
        }
        const double here = sum(h).after(h);
        return here >= 0 ? h : h * start / (start - here) * (1 - 0x1p-50);
    }

private:
    Arc sum(double h) const { return base_ + a_.least(h) + b_.least(h); }

    static Side side(const QuickPlace& place, const Quick3& n, const Quick3& om, double sign,
                     const Quick3& nearest)
    {
        Side out;
        out.place = &place;
        out.n = n;
        if (place.body->kind == Kind::ground) {
            // The axis is glued to it: height over the pivot's plane, on the side that n looks from.
            out.ground = (dot(n, place.normal) > 0 ? -1 : 1) * -place.body->offset;
            return out;
        }
        const Quick3& w = place.body->rotation;
        const Quick3 d = w - om;
        const Quick3 m = cross(n, d);
        out.by_swing = dot(om, om) == 0;
        out.turning = sign * m;
        const double along = out.by_swing ? norm(m) : norm(d);
        out.bend = (norm(cross(w, om)) + along * norm(d)) * (1 + 0x1p-40);
        out.turns = place.body->rate > 0;
        if (!out.turns && !out.by_swing) out.base = nearest;
        return out;
    }

    double most_;
    Arc base_;
    Side a_, b_;
};

/// By the balls about the pivots that hold the bodies.
double balls_hold(const QuickLook& at, const Quick3& v, double sign, double most, double level)
{
    if (at.a.body->kind == Kind::ground || at.b.body->kind == Kind::ground) return 0;
    const Quick3 d = at.b.pivot - at.a.pivot;
    const auto reach = [](const QuickBody& body) {
        return *std::max_element(body.reach.begin(), body.reach.end());
    };
    const double length = norm(d);
    const double apart = length - reach(*at.a.body) - reach(*at.b.body) - level;
    if (!(apart > 0)) return 0;
    const double closing = -sign * dot(d, v) / length;
    return closing * most <= apart ? most : apart / closing * (1 - 0x1p-40);
}

/// The turning that keeps the axis across the edges of both bodies on which the nearest points lie, to first
/// order: eta . e = -n . (w x e) for each. Zero where there is no edge.
Quick3 along_edges(const QuickLook& at)
{
    const Quick3& n = at.gap.normal;
    const auto flat = [&](const Quick3& e) { return e - dot(n, e) * n; };
    const Quick3 e = flat(at.gap.edge_a), f = flat(at.gap.edge_b);
    const double p = -dot(n, cross(at.a.body->rotation, at.gap.edge_a));
    const double q = -dot(n, cross(at.b.body->rotation, at.gap.edge_b));
    const double ee = dot(e, e), ff = dot(f, f), ef = dot(e, f);
    const double bent = ee * ff - ef * ef;
    Quick3 eta;
    if (bent > 1e-12 * ee * ff)
        eta = ((p * ff - q * ef) / bent) * e + ((q * ee - p * ef) / bent) * f;
    else if (ee >= ff && ee > 0)
        eta = (p / ee) * e;
    else if (ff > 0)
        eta = (q / ff) * f;
    return cross(n, eta);
}

/// The turning that takes one unit normal to another, to first order.
Quick3 secant(const Quick3& from, const Quick3& to, double after) { return (1 / after) * cross(from, to); }

} // namespace

QuickPair::QuickPair(const Query& q)
    : query_(q),
      origin_(q.motion_b.start.position),
      a_(quick_body(q.a, q.motion_a, origin_)),
      b_(quick_body(q.b, q.motion_b, origin_))
{
    // Of the positions as of the drift, only the difference counts.
    const Quick3 apart = vector_of<double>(q.motion_a.start.position - q.motion_b.start.position);
    const Quick3 by = b_.velocity - a_.velocity;
    scale_ =
        norm(apart) + norm(by) + (1 + a_.rate) * a_.extent + (1 + b_.rate) * b_.extent + q.options.target_gap;
    const double span = std::max(norm(b_.pivot - a_.pivot), norm(b_.pivot - a_.pivot + by));
    if (a_.kind == Kind::ground) scale_ += a_.rate * (span + b_.extent);
    if (b_.kind == Kind::ground) scale_ += b_.rate * (span + a_.extent);
    a_.velocity = a_.velocity - b_.velocity;
    b_.velocity = {};
}

Quick3 QuickPair::better_normal(double t) const
{
    const Vec3 n = rounded(GapOverTime(query_).at(t).normal);
    return {n.x(), n.y(), n.z()};
}

QuickLook::QuickLook(const QuickPair& pair, double when, const Quick3& hint, const QuickEffort& effort)
    : t(when), a(pair.a(), when), b(pair.b(), when), gap(quick_gap(a, b, hint, effort))
{
}

void QuickLook::try_normal(const Quick3& n)
{
    const bool ground = a.body->kind == Kind::ground || b.body->kind == Kind::ground;
    const bool unit = std::abs(dot(n, n) - 1) <= 16 * 0x1p-52;
    const double lower = unit && !ground ? quick_separation(a, b, n) : gap.lower;
    if (!(lower > gap.lower)) return;
    gap.lower = lower;
    gap.normal = n;
}

double quick_reach(const QuickPair& pair, const QuickLook& at, QuickWay way, double most, double level,
                   const std::optional<QuickToward>& toward)
{
    const double sign = static_cast<double>(way);
    const Quick3 v = pair.b().velocity - pair.a().velocity;
    const auto reach = [&](const Quick3& om) { return Certificate(at, v, om, sign * most, level).holds(); };
    if (pair.a().kind == Kind::ground) return reach(pair.a().rotation);
    if (pair.b().kind == Kind::ground) return reach(pair.b().rotation);
    double best = std::max(reach({}), balls_hold(at, v, sign, most, level));
    if (best >= most) return best;
    if (toward && dot(toward->normal, at.gap.normal) > 0.5)
        best = std::max(best, reach(sign * secant(at.gap.normal, toward->normal, toward->after)));
    if (best >= most) return best;
    const Quick3 edges = along_edges(at);
    if (dot(edges, edges) > 0) best = std::max(best, reach(edges));
    for (const QuickBody* body : {&pair.a(), &pair.b()})
        if (best < most && body->rate > 0) best = std::max(best, reach(body->rotation));
    return best;
}

namespace {

/// A stretch of time not yet proven, between two looks.
struct Stretch {
    double from, to;
    double t_from, t_to; // of the looks
    Quick3 n_from, n_to;
};

} // namespace

QuickProof quick_apart(const QuickPair& pair, const QuickLook& from, const QuickLook& to, double level,
                       int budget)
{
    QuickProof out;
    if (!(from.gap.lower > level && to.gap.lower > level)) return out;
    const double span = to.t - from.t;
    if (!(span > 0)) return {true, 0};
    const double on = quick_reach(pair, from, QuickWay::on, span, level, QuickToward{to.gap.normal, span});
    if (on >= span) return {true, 0};
    const double back =
        quick_reach(pair, to, QuickWay::back, span, level, QuickToward{from.gap.normal, span});
    std::vector<Stretch> open{{from.t + on, to.t - back, from.t, to.t, from.gap.normal, to.gap.normal}};
    while (!open.empty()) {
        const Stretch s = open.back();
        open.pop_back();
        if (s.from >= s.to) continue;
        const double middle = s.from + (s.to - s.from) / 2;
        if (out.looks >= budget || !(middle > s.from && middle < s.to)) return out;
        ++out.looks;
        QuickLook look(pair, middle, s.n_from + s.n_to, {0, 0.1, level});
        if (!(look.gap.lower > level) && look.gap.upper > level) look.try_normal(pair.better_normal(middle));
        if (!(look.gap.lower > level)) return out;
        const Quick3& n = look.gap.normal;
        const double before = quick_reach(pair, look, QuickWay::back, middle - s.from, level,
                                          QuickToward{s.n_from, middle - s.t_from});
        const double after =
            quick_reach(pair, look, QuickWay::on, s.to - middle, level, QuickToward{s.n_to, s.t_to - middle});
        open.push_back({s.from, middle - before, s.t_from, middle, s.n_from, n});
        open.push_back({middle + after, s.to, middle, s.t_to, n, s.n_to});
    }
    out.apart = true;
    return out;
}

} // namespace brink::support
