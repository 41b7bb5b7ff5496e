// SPDX-License-Identifier: BSD-3-Clause
#include "crossing.h"
#include "glance.h"
#include "lanes.h"
#include "pairs.h"
#include "separating_axes.h"
#include "sharp.h"

#include <algorithm>
#include <bit>

namespace brink {

namespace {

/// The cross product with sums in place of differences.
template <class T> XYZ<T> cross_sum(XYZ<T> a, XYZ<T> b)
{
    return {a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x};
}

/// The slabs that make up the difference of two boxes. Lanes 0 to 5 are the axes B 0, 1, 2 and A 2, 0, 1; the
/// cross products of B's axis i with A's axis j follow, whose components are those of A's axis in B's frame.
struct AxisPair {
    signed char b, a; // -1: none
};
constexpr AxisPair lanes[] = {{0, -1}, {1, -1}, {2, -1}, {-1, 2}, {-1, 0}, {-1, 1}, {0, 0}, {0, 1},
                              {1, 0},  {1, 1},  {2, 0},  {2, 1},  {0, 2},  {1, 2},  {2, 2}};

Slabs<8> slabs_of(const Rotation& turn_a, const Rotation& turn_b, V3 half_a, V3 half_b, const Approach& m)
{
    const V3 from = into(turn_b, m.from), by = into(turn_b, m.by);
    const V3 a0 = into(turn_b, turn_a.x), a1 = into(turn_b, turn_a.y), a2 = into(turn_b, turn_a.z);
    const V3 size0 = magnitudes(a0), size1 = magnitudes(a1), size2 = magnitudes(a2);
    const XYZ<Two> first = pair(a0, a1), first_size = pair(size0, size1), half = both(half_b);
    const V3 reach_b = half_b + half_a.x * size0 + half_a.y * size1 + half_a.z * size2;
    Slabs<8> out;
    out.set(0, Two{from.x, from.y}, Two{by.x, by.y}, Two{reach_b.x, reach_b.y});
    out.set(1, Two{from.z, dot(a2, from)}, Two{by.z, dot(a2, by)},
            Two{reach_b.z, half_a.z + dot(size2, half_b)});
    out.set(2, dot(first, both(from)), dot(first, both(by)), Two{half_a.x, half_a.y} + dot(first_size, half));

    const XYZ<Two> at = cross(first, both(from)), rate = cross(first, both(by));
    const XYZ<Two> swapped = pair(size1, size0), rest = both(size2);
    const XYZ<Two> reach =
        cross_sum(first_size, half) + (both(half_a.z) * swapped + Two{half_a.y, half_a.x} * rest);
    out.set(3, at.x, rate.x, reach.x);
    out.set(4, at.y, rate.y, reach.y);
    out.set(5, at.z, rate.z, reach.z);
    const V3 at_2 = cross(a2, from), rate_2 = cross(a2, by);
    const V3 reach_2 = cross_sum(size2, half_b) + (half_a.x * size1 + half_a.y * size0);
    out.set(6, Two{at_2.x, at_2.y}, Two{rate_2.x, rate_2.y}, Two{reach_2.x, reach_2.y});
    out.set(7, Two{at_2.z}, Two{rate_2.z}, Two{reach_2.z, tolerance::largest_lengths});
    return out;
}

V3 axis_of(const Rotation& turn, int i) { return i == 0 ? turn.x : i == 1 ? turn.y : turn.z; }
double part(V3 v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }

/// Two boxes on their way, in the world's axes.
class Boxes {
public:
    Boxes(const Box& a, const Box& b, const Approach& m)
        : a_(a),
          b_(b),
          m_(m),
          turn_a_(m.turn_a()),
          turn_b_(m.turn_b()),
          half_a_(load(a.half_extents)),
          half_b_(load(b.half_extents)),
          extents_(norm(half_a_) + norm(half_b_)),
          reach_(reach(m, m.target_gap, extents_)),
          margin_(tolerance::slab_slack * (reach_.lengths + extents_)),
          slabs_(slabs_of(turn_a_, turn_b_, half_a_, half_b_, m))
    {
    }

    Entry entry() const
    {
        const Stay stay = slabs_.stay(margin_ + m_.target_gap);
        if (stay.in > stay.out) return {.found = Found::apart};
        if (stay.axis < 0 || m_.target_gap > 0) return {.t = stay.in};
        const V3 axis = plain_axis(stay.axis);
        const double length_squared = norm_squared(axis);
        const Crossing c = along(axis, std::sqrt(length_squared));
        if (!c.closing || c.blurred() || reach_.strained || !(length_squared > tolerance::nearly_parallel))
            return among_ties(stay.in, 1U << static_cast<unsigned>(stay.axis));
        const unsigned open = slabs_.contested(margin_, c.t, c.t_upper);
        if (open != 1U << static_cast<unsigned>(stay.axis)) return among_ties(stay.in, open);
        return {Found::hit, c.t, c.t_upper, meeting(stay.axis, axis, length_squared, c.t)};
    }

private:
    /// From B to A, as far as the motion says.
    V3 facing(V3 axis) const { return dot(axis, m_.by) > 0 ? -axis : axis; }
    V3 plain_axis(int lane) const
    {
        const AxisPair p = lanes[lane];
        if (p.a < 0) return facing(axis_of(turn_b_, p.b));
        if (p.b < 0) return facing(axis_of(turn_a_, p.a));
        return facing(cross(axis_of(turn_b_, p.b), axis_of(turn_a_, p.a)));
    }
    V3 careful_axis(int lane) const
    {
        const AxisPair p = lanes[lane];
        if (p.a < 0 || p.b < 0) return plain_axis(lane);
        return facing(careful_cross(axis_of(turn_b_, p.b), axis_of(turn_a_, p.a)));
    }

    /// How far both boxes reach along an axis.
    double reach_along(V3 n) const
    {
        return dot(magnitudes(into(turn_a_, n)), half_a_) + dot(magnitudes(into(turn_b_, n)), half_b_);
    }
    Crossing along(V3 axis, double length) const
    {
        return crossing(dot(axis, m_.from) - reach_along(axis), -dot(axis, m_.by), reach_.slack * length,
                        tolerance::overlap_depth);
    }
    /// Whether both boxes certainly reach over each other along an axis; parallel edges have none.
    bool overlap(V3 axis, double t) const
    {
        const double length = norm(axis), deep = (tolerance::overlap_depth - 1) * reach_.slack * length;
        return length == 0 || reach_along(axis) - std::fabs(dot(axis, m_.from + t * m_.by)) >= deep;
    }
    Entry among_ties(double early, unsigned open) const;
    std::optional<Meeting> meeting(int lane, V3 n, double length_squared, double t) const;

    const Box& a_;
    const Box& b_;
    const Approach& m_;
    Rotation turn_a_, turn_b_;
    V3 half_a_, half_b_;
    double extents_;
    Reach reach_;
    double margin_;
    Slabs<8> slabs_;
};

/// Where several axes are entered at about the same time, as those of equal faces are, or slowly, or by
/// nearly parallel edges: each of them by itself, with all care.
[[gnu::noinline]] Entry Boxes::among_ties(double early, unsigned open) const
{
    double t = early, t_upper = early;
    unsigned asked = 0;
    for (; open != 0; open = slabs_.contested(margin_, t, t_upper) & ~asked) {
        const int lane = std::countr_zero(open);
        asked |= 1U << static_cast<unsigned>(lane);
        const V3 axis = careful_axis(lane);
        const Crossing c = along(axis, norm(axis));
        if (!c.closing) continue;
        t_upper = std::max(t_upper, c.t_upper);
        const bool rough = c.blurred() || reach_.strained;
        t = std::max(t, rough ? sharp::later(a_, b_, m_, axis, {}, reach_.lengths + extents_, c.t) : c.t);
    }
    for (; asked != 0; asked &= asked - 1)
        if (!overlap(careful_axis(std::countr_zero(asked)), t_upper)) return {.t = t};
    return {Found::hit, t, t_upper};
}

/// The corner that lies farthest along n, seen from the box's origin.
V3 corner(const Rotation& turn, V3 half, V3 n)
{
    const V3 local = into(turn, n);
    return turn *
           V3{std::copysign(half.x, local.x), std::copysign(half.y, local.y), std::copysign(half.z, local.z)};
}

/// Whether a point lies over the inside of the face at right angles to the box's axis i.
bool over_face(V3 local, V3 half, int i)
{
    const V3 size = magnitudes(local);
    return all(i == 0 || size.x < half.x, i == 1 || size.y < half.y, i == 2 || size.z < half.z);
}

/// Where they meet at t, if it is a corner inside a face or two edges between their ends.
std::optional<Meeting> Boxes::meeting(int lane, V3 n, double length_squared, double t) const
{
    const AxisPair p = lanes[lane];
    const V3 at = m_.from + t * m_.by;
    if (p.a < 0) {
        const V3 met = at + corner(turn_a_, half_a_, -n), local = into(turn_b_, met);
        if (!over_face(local, half_b_, p.b)) return {};
        return Meeting{met, met - (std::fabs(part(local, p.b)) - part(half_b_, p.b)) * n, -n, true};
    }
    if (p.b < 0) {
        const V3 met = corner(turn_b_, half_b_, n), local = into(turn_a_, met - at);
        if (!over_face(local, half_a_, p.a)) return {};
        return Meeting{met + (std::fabs(part(local, p.a)) - part(half_a_, p.a)) * n, met, -n, true};
    }
    const V3 along_a = axis_of(turn_a_, p.a), along_b = axis_of(turn_b_, p.b);
    const double cosine = dot(along_a, along_b);
    V3 edge_a = at + corner(turn_a_, half_a_, -n), edge_b = corner(turn_b_, half_b_, n);
    edge_a = edge_a - dot(edge_a - at, along_a) * along_a; // the middles of the edges
    edge_b = edge_b - dot(edge_b, along_b) * along_b;
    const V3 between = edge_b - edge_a;
    const double a = dot(between, along_a), b = dot(between, along_b);
    const double on_a = (a - cosine * b) / length_squared, on_b = (cosine * a - b) / length_squared;
    if (!all(std::fabs(on_a) < part(half_a_, p.a), std::fabs(on_b) < part(half_b_, p.b))) return {};
    return Meeting{edge_a + on_a * along_a, edge_b + on_b * along_b, -n, true};
}

} // namespace

/// Boxes without radius meet when the last of their 15 slabs is entered. Within a target gap of each other
/// they are left in doubt.
Entry box_box(const Box& a, const Box& b, const Approach& m) { return cut(Boxes(a, b, m).entry(), m.t_max); }

} // namespace brink
