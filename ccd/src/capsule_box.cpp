// SPDX-License-Identifier: BSD-3-Clause
#include "crossing.h"
#include "glance.h"
#include "pairs.h"
#include "quadratic.h"
#include "rounded_polygon.h"
#include "separating_axes.h"
#include "sharp.h"

#include <algorithm>

namespace brink {

namespace {

/// Steps of the walk towards contact: every other one changes the features that are nearest.
constexpr int most_steps = 24;

/// A segment on its way past a box, in the box's axes.
struct Passing {
    V3 start, edge, by; // the segment at t = 0
    V3 half;            // of the box

    V3 point(double t, double on) const { return start + t * by + on * edge; }
};

double beyond(double x, double half) { return x - std::clamp(x, -half, half); }
V3 beyond(V3 p, V3 half) { return {beyond(p.x, half.x), beyond(p.y, half.y), beyond(p.z, half.z)}; }
Two beyond(Two x, double half) { return x - smaller(larger(x, both(-half)), both(half)); }

/// Half the slope of the squared distance to the box along the segment: piecewise linear, never falling.
Two slope(const Passing& s, V3 start, Two on)
{
    return both(s.edge.x) * beyond(both(start.x) + on * both(s.edge.x), s.half.x) +
           both(s.edge.y) * beyond(both(start.y) + on * both(s.edge.y), s.half.y) +
           both(s.edge.z) * beyond(both(start.z) + on * both(s.edge.z), s.half.z);
}

/// The last place where the slope is not above zero and the first where it is.
struct Dip {
    Two below{}, at_below = both(-1), above = both(1), at_above = both(1);

    void look(Two on, Two value)
    {
        const TwoFlags rises = value > 0, later = ~rises & (on >= below), sooner = rises & (on <= above);
        below = select(later, on, below);
        at_below = select(later, value, at_below);
        above = select(sooner, on, above);
        at_above = select(sooner, value, at_above);
    }
};

/// Where on the segment, 0 to 1, it comes nearest to the box. The slope is asked where coordinates enter or
/// leave the box's slabs; between two of those it is a straight line.
double nearest_to_box(const Passing& s, V3 start)
{
    const Two ends{0, 1}, at_ends = slope(s, start, ends);
    if (!(at_ends[0] < 0)) return 0;
    if (!(at_ends[1] > 0)) return 1;
    Dip dip;
    dip.at_below = both(at_ends[0]);
    dip.at_above = both(at_ends[1]);
    const auto look = [&](double from, double edge, double half) {
        const Two on = smaller(larger((Two{-half, half} - both(from)) / both(edge), both(0)), both(1));
        dip.look(on, slope(s, start, on));
    };
    look(start.x, s.edge.x, s.half.x);
    look(start.y, s.edge.y, s.half.y);
    look(start.z, s.edge.z, s.half.z);
    const int low = dip.below[1] > dip.below[0] ? 1 : 0, high = dip.above[1] < dip.above[0] ? 1 : 0;
    const double from = dip.below[low], fall = -dip.at_below[low], rise = dip.at_above[high];
    return from + (dip.above[high] - from) * (fall / (fall + rise));
}

/// The features that are nearest at a time.
struct Near {
    double on;  // the place on the segment
    V3 out;     // from the box to there
    V3 sliding; // the segment's direction across the box's edge or corner, where it crosses one; else zero
};

V3 masked(V3 v, V3 mask) { return {mask.x != 0 ? v.x : 0, mask.y != 0 ? v.y : 0, mask.z != 0 ? v.z : 0}; }
int sides(V3 out) { return (out.x != 0) + (out.y != 0) + (out.z != 0); }

Near near_at(const Passing& s, double t)
{
    const V3 start = s.point(t, 0);
    const double on = nearest_to_box(s, start);
    const V3 out = beyond(start + on * s.edge, s.half);
    const bool between = all(on > 0, on<1, sides(out)> 1);
    return {on, out, between ? masked(s.edge, out) : V3{}};
}

/// v without its part along e.
V3 without(V3 v, V3 e)
{
    const double length_squared = norm_squared(e);
    return length_squared > 0 ? v - (dot(v, e) / length_squared) * e : v;
}

/// When two features meet, guessed, and what meets there: in the box's axes.
struct Contact {
    double t = infinity;
    double on = 0; // the place on the segment
    V3 out{};      // from the box to there
    V3 sliding{};
};

class CapsuleBox {
public:
    CapsuleBox(const Capsule& a, const Box& b, const Approach& m)
        : a_(a),
          b_(b),
          m_(m),
          turn_(m.turn_b()),
          start_(m.turn_a() * load(a.a)),
          edge_(m.turn_a() * load(a.b) - start_),
          local_{into(turn_, m.from + start_), into(turn_, edge_), into(turn_, m.by), load(b.half_extents)},
          extents_(std::sqrt(std::max(norm_squared(start_), norm_squared(start_ + edge_))) +
                   norm(local_.half)),
          reach_(reach(m, a.radius + m.target_gap, extents_)),
          margin_(tolerance::slab_slack * (reach_.lengths + extents_))
    {
    }

    Entry entry() const
    {
        const Stay stay = slabs().stay(0);
        if (stay.in > stay.out) return {.found = Found::apart};
        const Near near = near_at(local_, stay.in);
        const double over = norm(near.out) - wide();
        const Contact first =
            over <= doubt() ? Contact{stay.in, near.on, near.out, near.sliding} : landing(near, stay.in);
        if (first.t > 0 && first.t <= stay.out) {
            const Entry e = proof(first, stay.in);
            if (e.found == Found::hit) return e;
        }
        return walk(stay);
    }

private:
    double wide() const { return reach_.radius + margin_; }
    double doubt() const { return 0.25 * margin_; } // how far off distances may be

    Slabs<3> slabs() const;
    Contact landing(const Near& near, double t) const;
    Entry walk(Stay stay) const;
    Entry proof(const Contact& c, double early) const;

    const Capsule& a_;
    const Box& b_;
    const Approach& m_;
    Rotation turn_;   // of the box
    V3 start_, edge_; // the capsule's segment, from A's origin, in the world's axes
    Passing local_;
    double extents_;
    Reach reach_;
    double margin_;
};

/// The box's own axes, and those times the segment. The latter are as long as the segment, and so is what
/// rounding may do along them.
Slabs<3> CapsuleBox::slabs() const
{
    const Passing& s = local_;
    const V3 from = s.start + 0.5 * s.edge, at = cross(s.edge, from), rate = cross(s.edge, s.by);
    const V3 size = magnitudes(s.edge), square{size.x * size.x, size.y * size.y, size.z * size.z};
    const double far = wide(), rough = margin_ * (size.x + size.y + size.z);
    const Two across = square_root(Two{square.y + square.z, square.z + square.x});
    const double last = std::sqrt(square.x + square.y), r = reach_.radius;
    const V3 face = s.half + 0.5 * size;
    Slabs<3> out;
    out.set(0, Two{from.x, from.y}, Two{s.by.x, s.by.y}, Two{face.x + far, face.y + far});
    out.set(1, Two{from.z, at.x}, Two{s.by.z, rate.x},
            Two{face.z + far, s.half.y * size.z + s.half.z * size.y + r * across[0] + rough});
    out.set(2, Two{at.y, at.z}, Two{rate.y, rate.z},
            Two{s.half.z * size.x + s.half.x * size.z + r * across[1] + rough,
                s.half.x * size.y + s.half.y * size.x + r * last + rough});
    return out;
}

/// Where the features that are nearest at t would meet if they went on for ever.
Contact CapsuleBox::landing(const Near& near, double t) const
{
    const V3 by = masked(local_.by, near.out), across = without(by, near.sliding);
    const double step = ray_ball(near.out, across, wide());
    if (!(step < infinity)) return {};
    const double length_squared = norm_squared(near.sliding);
    const double slide = length_squared > 0 ? dot(by, near.sliding) / length_squared : 0;
    return {t + step, clamped(near.on - step * slide), near.out + step * across, near.sliding};
}

/// The distance is convex over time. From a time before contact, straight to where the features that are
/// nearest then would meet; or, where that has gone too far, to where the tangent does, which never is.
[[gnu::noinline]] Entry CapsuleBox::walk(Stay stay) const
{
    bool leapt = false;
    double t = stay.in, tangent = t;
    for (int step = 0; step < most_steps; ++step) {
        const Near near = near_at(local_, t);
        const double distance = norm(near.out), over = distance - wide(), closing = -dot(near.out, local_.by);
        if (leapt && (closing <= 0 || over < -doubt())) {
            t = tangent;
            leapt = false;
            continue;
        }
        if (over <= doubt()) return t > 0 ? proof({t, near.on, near.out, near.sliding}, t) : Entry{};
        if (closing <= 0 || t >= stay.out) return {.found = Found::apart};
        tangent = t + over * distance / closing;
        if (tangent > stay.out) return {.found = Found::apart};
        const double landed = landing(near, t).t;
        leapt = landed < infinity;
        t = leapt ? std::min(std::max(landed, tangent), stay.out) : tangent;
    }
    return {.t = tangent};
}

/// Proven in the world's axes, where turning does not touch the path.
Entry CapsuleBox::proof(const Contact& c, double early) const
{
    if (sides(c.out) == 0 || !(reach_.radius > tolerance::thin * (reach_.lengths + extents_)))
        return {.t = early};
    const V3 half = local_.half, out = without(c.out, c.sliding), axis = turn_ * out;
    const V3 end = start_ + edge_, on = start_ + c.on * edge_;
    const double height =
        dot(axis, m_.from) + std::min(dot(axis, start_), dot(axis, end)) - dot(magnitudes(out), half);
    Entry e = proven(
        whole_step(m_), reach_, axis, height, early,
        [&](V3 p) {
            const V3 q = into(turn_, p + on);
            return turn_ * (q - beyond(q, half)) - on;
        },
        [&](V3 n, double time) {
            const Pair radius = two_sum(a_.radius, m_.target_gap);
            return sharp::later(a_, b_, m_, n, radius, reach_.lengths + extents_, time);
        });
    if (!e.meeting) return e;
    Meeting& at = *e.meeting;
    at.core_a = at.core_a + on;
    at.core_b = at.core_b + on;
    at.flat = sides(out) == 1 && sides(beyond(into(turn_, at.core_a), half)) == 1;
    return e;
}

} // namespace

/// A moving segment against the box grown by the radius: in the box's axes it is walked to, in the world's it
/// is proven.
Entry capsule_box(const Capsule& a, const Box& b, const Approach& m)
{
    return cut(CapsuleBox(a, b, m).entry(), m.t_max);
}

} // namespace brink
