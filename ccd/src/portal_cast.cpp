// SPDX-License-Identifier: BSD-3-Clause
#include "portal_cast.h"

#include "crossing.h"
#include "glance.h"
#include "support.h"

#include <algorithm>
#include <optional>

namespace brink {

namespace {

/// Rounds of either part: far more than corners that can matter.
constexpr int most_rounds = 48;

/// A point of B's core less one of A's, seen from the path's start, and where it is across the path.
struct Point {
    V3 place;
    V3 on_a;
    double u = 0, v = 0;
    bool sure = true; // that it is one: a hull's middle is that of a ball about it, and may lie outside
};

/// Twice the area of the triangle that the path makes with two points, seen along it.
double turn(const Point& p, const Point& q) { return p.u * q.v - p.v * q.u; }

class Cast {
public:
    Cast(const Core& a, const Core& b, const Approach& m);
    Entry entry();

private:
    bool passes_by() const;
    Point across(V3 of_b, V3 of_a) const;
    Point farthest(V3 n) const;
    /// The axis across the path along which a point's height is x u + y v.
    V3 axis(double x, double y) const { return x * u_ + y * v_; }

    bool apart_along(V3 n, const Point& top) const;
    /// Whether the portal's corners all lie in the supporting plane, rounding of its normal included.
    bool in_plane(V3 n, const Point& top) const
    {
        const double least = dot(n, top.place) - reach_.slack * norm(n);
        return all(dot(n, portal_[0].place) >= least, dot(n, portal_[1].place) >= least,
                   dot(n, portal_[2].place) >= least);
    }
    std::optional<Entry> open_portal();
    Entry refined();
    Entry surface(V3 n, const Crossing& c) const;
    Entry missed(V3 n, const Point& top) const
    {
        return apart_along(n, top) ? Entry{.found = Found::apart} : Entry{};
    }

    const Approach& m_;
    Core a_, b_; // turned
    Reach reach_;
    V3 u_, v_; // unit vectors across the path
    Point portal_[3];
};

Cast::Cast(const Core& a, const Core& b, const Approach& m)
    : m_(m),
      a_(placed(a, m.turn_a(), {})),
      b_(placed(b, m.turn_b(), {})),
      reach_(reach(m, 0, brink::reach(a_) + brink::reach(b_))),
      u_(any_perpendicular(m.by)),
      v_((1 / norm(m.by)) * cross(u_, m.by))
{
}

Point Cast::across(V3 of_b, V3 of_a) const
{
    const V3 place = (of_b - of_a) - m_.from;
    return {place, of_a, dot(u_, place), dot(v_, place)};
}

Point Cast::farthest(V3 n) const
{
    return across(brink::farthest(b_, n).point, brink::farthest(a_, -n).point);
}

/// Whether the supporting plane at right angles to n, which `top` lies on, keeps the path's point apart
/// throughout the step.
bool Cast::apart_along(V3 n, const Point& top) const
{
    const double above = -dot(n, top.place) - reach_.slack * norm(n);
    return above > 0 && above + dot(n, m_.by) > 0;
}

/// A ball about a turned core's middle.
double ball(const Core& c)
{
    const double radius = c.kind == Core::Kind::hull  ? c.hull->ball * norm(c.axes.x)
                          : c.kind == Core::Kind::box ? norm(c.half_extents)
                                                      : norm(middle(c)) + brink::reach(c);
    return radius * (1 + tolerance::holding_slack);
}

/// Whether balls about the cores never touch: half of all misses end there.
bool Cast::passes_by() const
{
    const V3 from = m_.from + (middle(a_) - middle(b_));
    const double radius = ball(a_) + ball(b_) + reach_.margin, speed_squared = norm_squared(m_.by);
    const double closing = -dot(from, m_.by);
    const double s = closing > 0 ? std::min(closing, speed_squared) : 0; // of the path, times speed squared
    return norm_squared(speed_squared * from + s * m_.by) >
           radius * radius * speed_squared * speed_squared * (1 + tolerance::holding_slack);
}

/// Seen along the path, a triangle that it passes through: the middle of the difference and two corners,
/// found by turning about the middle and then moving outwards. Empty where there is one.
std::optional<Entry> Cast::open_portal()
{
    Point middle = across(brink::middle(b_), brink::middle(a_));
    middle.sure = a_.kind != Core::Kind::hull && b_.kind != Core::Kind::hull;
    const bool centred = middle.u == 0 && middle.v == 0;
    V3 way = centred ? u_ : axis(-middle.u, -middle.v);
    Point p = farthest(way);
    if (dot(way, p.place) < 0) return missed(way, p);
    const double side = turn(middle, p) < 0 ? -1 : 1;
    Point q;
    int rounds = 0;
    do {
        if (++rounds > most_rounds) return Entry{};
        if (rounds > 1) p = q;
        way = axis(-side * (p.v - middle.v), side * (p.u - middle.u));
        q = farthest(way);
        if (dot(way, q.place) < 0) return missed(way, q);
    } while (side * turn(middle, q) > 0);
    while (side * turn(p, q) < 0) {
        if (++rounds > most_rounds) return Entry{};
        way = axis(side * (q.v - p.v), -side * (q.u - p.u));
        const Point far = farthest(way);
        if (dot(way, far.place) < 0) return missed(way, far);
        (side * turn(middle, far) > 0 ? p : q) = far;
    }
    portal_[0] = middle;
    portal_[1] = side > 0 ? p : q;
    portal_[2] = side > 0 ? q : p;
    return {};
}

/// The portal moved outwards, against the path, until it lies in the surface.
Entry Cast::refined()
{
    for (int round = 0; round < most_rounds; ++round) {
        const V3 edge = portal_[1].place - portal_[0].place;
        const V3 n = cross(edge, portal_[2].place - portal_[0].place);
        const double slack = reach_.slack * norm(n);
        const Point top = farthest(n);
        const Crossing c = crossing(-dot(n, top.place), -dot(n, m_.by), slack);
        if (c.closing && c.t > 1) return {.found = Found::apart};
        if (dot(n, top.place - portal_[1].place) <= slack) return in_plane(n, top) ? surface(n, c) : Entry{};
        const double turns[] = {turn(portal_[0], top), turn(portal_[1], top), turn(portal_[2], top)};
        int kept = 0; // with the next one
        while (kept < 3 && !(turns[kept] <= 0 && turns[(kept + 1) % 3] >= 0))
            ++kept;
        if (kept == 3) return {};
        portal_[(kept + 2) % 3] = top;
    }
    return {};
}

/// The portal lies in a supporting plane and the path passes through it: contact between the two crossings,
/// unless that is at the portal's border, where it is as good as that.
Entry Cast::surface(V3 n, const Crossing& c) const
{
    const bool sure = all(portal_[0].sure, portal_[1].sure, portal_[2].sure);
    if (!sure || !c.closing || c.blurred()) return {};
    const double drift = norm(m_.by) * (c.t_upper - c.t);
    const V3 at = c.t * m_.by;
    double weight[3], sum = 0;
    bool inside = true;
    for (int i = 0; i < 3; ++i) {
        const Point &p = portal_[(i + 1) % 3], &q = portal_[(i + 2) % 3];
        inside &= turn(p, q) >= (8 * reach_.slack + drift) * norm(q.place - p.place);
        weight[i] = std::max(0.0, dot(n, cross(p.place - at, q.place - at)));
        sum += weight[i];
    }
    if (!(sum > 0)) return {.t = c.t};
    V3 on_a{}, between{};
    for (int i = 0; i < 3; ++i) {
        on_a = on_a + (weight[i] / sum) * portal_[i].on_a;
        between = between + (weight[i] / sum) * portal_[i].place;
    }
    const V3 met = m_.from + at + on_a, gap = between - at;
    if (!inside && norm(gap) > tolerance::loose_axis * reach_.slack) return {.t = c.t};
    Entry entry{Found::hit, c.t, infinity, Meeting{met, met + gap, -n, true}};
    if (inside) entry.t_upper = c.t_upper;
    return entry;
}

Entry Cast::entry()
{
    if (m_.by == V3{}) return {};
    if (passes_by()) return {.found = Found::apart};
    const std::optional<Entry> without_portal = open_portal();
    return without_portal ? *without_portal : refined();
}

} // namespace

Entry portal_cast(const Core& a, const Core& b, const Approach& m)
{
    const bool plain = all(a.radius + b.radius + m.target_gap == 0, is_polytope(a), is_polytope(b));
    return plain ? cut(Cast(a, b, m).entry(), m.t_max) : Entry{};
}

} // namespace brink
