// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falling.h"
#include "shadow.h"
#include "tolerance.h"

#include <algorithm>

namespace brink {

/// A height along an axis as a line in h, and what it may bend by: off by bend h^2 / 2 at most.
struct Arc {
    Line line;
    double bend = 0;
    V3 point; // whose it is
};

/// Directions across an axis that tell how long a vector across it is, or too long by `ring_excess` at most.
class Ring {
public:
    explicit Ring(V3 axis)
    {
        const V3 x = any_perpendicular(axis), y = cross(axis, x);
        constexpr double c = 0.70710678118654757;
        const V3 ring[4] = {x, c * (x + y), y, c * (y - x)};
        for (int k = 0; k < 4; ++k)
            at_[k] = tolerance::ring_excess * ring[k];
    }
    double length(V3 v) const
    {
        double most = 0;
        for (const V3 e : at_)
            most = std::max(most, std::fabs(dot(e, v)));
        return most;
    }
    /// Of a body's points p the one with the largest along . r + weight length(v), r = p - from, where v is
    /// linear in r: e . v = towards(e) . r.
    template <class Towards>
    V3 farthest(const Core& body, V3 from, V3 along, double weight, Towards towards) const
    {
        V3 best;
        double highest = -infinity;
        for (const V3 e : at_)
            for (const double side : {-weight, weight}) {
                const V3 d = along + side * towards(e);
                const V3 p = brink::farthest(body, d).point;
                const double height = dot(d, p - from);
                if (height > highest) highest = height, best = p;
            }
        return best;
    }

private:
    V3 at_[4];
};

/// A gap as the least of many parabolas, one for each pair of points, which are those of A's arcs, B's arcs
/// and a common one: so it is concave. OfA and OfB tell the arc that reaches farthest at some h.
template <class OfA, class OfB> class Arches {
public:
    Arches(const OfA& a, const OfB& b, Line rest, double bend) : a_(a), b_(b), rest_(rest), bend_(bend) {}

    double now() const { return lowest(0).line.value; }
    struct Last {
        double h = 0, bend = 0;
        V3 on_a, on_b; // the points that end it
    };
    /// Newton's method from outside: an h, as large as it finds it, up to which all are at `level` or above.
    /// If it has not come there it is the chord's, which lies below a concave function.
    Last last(double level, double horizon) const
    {
        Lowest low = lowest(0);
        Last out{0, 0, low.on_a, low.on_b};
        if (!(low.line.value >= level)) return out;
        const double spare = low.line.value - level;
        double x = horizon;
        for (int i = 0;; ++i) {
            low = lowest(x);
            out.bend = low.bend;
            const double left = low.line.at(x) - 0.5 * low.bend * x * x - level;
            if (left >= 0) out.h = x;
            if (left >= 0) return out;
            out.on_a = low.on_a;
            out.on_b = low.on_b;
            if (i == newton_rounds) out.h = x * (spare / (spare - left)) * tolerance::step_shrink;
            if (i == newton_rounds) return out;
            const double above = std::max(0.0, low.line.value - level);
            x = std::min(x, falls(above, low.line.slope, low.bend) * tolerance::step_shrink);
        }
    }

private:
    static constexpr int newton_rounds = 16;
    struct Lowest {
        Line line;
        double bend;
        V3 on_a, on_b;
    };
    Lowest lowest(double h) const
    {
        const Arc on_a = a_.extreme(h), on_b = b_.extreme(h);
        return {(on_b.line - on_a.line) + rest_, bend_ + on_a.bend + on_b.bend, on_a.point, on_b.point};
    }

    const OfA& a_;
    const OfB& b_;
    Line rest_;
    double bend_;
};

} // namespace brink
