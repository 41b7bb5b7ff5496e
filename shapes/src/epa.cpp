// SPDX-License-Identifier: BSD-3-Clause
#include "epa.h"

#include "expanding_polytope.h"
#include "nearest.h"
#include "round_axis.h"
#include "support.h"

#include <algorithm>

namespace brink {

namespace {

using Corner = Simplex::Corner;

constexpr int most_rounds = 256; // more than the polytope has room for

/// The corner of the difference B - A that lies farthest along m.
Corner extreme(const Core& a, const Core& b, V3 m)
{
    const SupportPoint on_a = farthest(a, -m), on_b = farthest(b, m);
    return {on_b.point - on_a.point, on_a.point, on_b.point, on_a.corner, on_b.corner, 1};
}

/// Of two corners the one that is farther by some measure of its place.
template <class Measure> Corner farther(const Corner& p, const Corner& q, Measure measure)
{
    return measure(q.w) > measure(p.w) ? q : p;
}

/// Four corners far apart; fewer where the difference has no volume.
int spread(const Core& a, const Core& b, double slack, Corner (&c)[4])
{
    const auto length = [&](V3 w) { return norm_squared(w - c[0].w); };
    for (const V3 axis : {V3{1, 0, 0}, V3{0, 1, 0}, V3{0, 0, 1}}) {
        const Corner low = extreme(a, b, -axis), high = extreme(a, b, axis);
        const bool longer = norm_squared(high.w - low.w) > length(c[1].w);
        if (longer || axis.x == 1) c[0] = low, c[1] = high;
    }
    if (!(norm(c[1].w - c[0].w) > slack)) return 1;

    const V3 along = c[1].w - c[0].w, aside = any_perpendicular(along);
    const V3 upright = (1 / norm(along)) * cross(along, aside);
    const auto width = [&](V3 w) { return norm_squared(across(w - c[0].w, along)); };
    c[2] = farther(farther(extreme(a, b, aside), extreme(a, b, -aside), width),
                   farther(extreme(a, b, upright), extreme(a, b, -upright), width), width);
    if (!(width(c[2].w) > slack * slack)) return 2;

    const V3 n = face_normal(c[0].w, c[1].w, c[2].w), normal = (1 / norm(n)) * n;
    if (n == V3{}) return 2;
    const auto height = [&](V3 w) { return std::fabs(dot(normal, w - c[0].w)); };
    c[3] = farther(extreme(a, b, normal), extreme(a, b, -normal), height);
    return height(c[3].w) > slack ? 4 : 3;
}

/// A difference without a volume: its own plane, or one that holds its line or point.
Penetration flat(const Core& a, const Core& b, const Corner (&c)[4], int size)
{
    V3 n = size == 3 ? face_normal(c[0].w, c[1].w, c[2].w) : any_perpendicular(c[size - 1].w - c[0].w);
    n = (1 / norm(n)) * n;
    const double ahead = gap_along(a, b, n), behind = gap_along(a, b, -n);
    const double gap = std::max(ahead, behind);
    Simplex simplex;
    for (int i = 0; i < size; ++i)
        simplex.add(c[i]), simplex.reduce();
    for (int round = 0; round < most_rounds; ++round) {
        const V3 v = simplex.point();
        const Corner corner = extreme(a, b, dot(n, v) * n - v);
        if (simplex.size == 4 || simplex.contains(corner)) break;
        Simplex next = simplex;
        next.add(corner);
        next.reduce();
        if (!(norm_squared(next.point()) < norm_squared(v))) break;
        simplex = next;
    }
    const Witness w = witness(simplex);
    return {gap, gap, ahead >= behind ? n : -n, w.on_a, w.v};
}

/// The axis that turns out to be the best as faces nearest to the origin, or the farthest before it, grow;
/// and the least offset at last.
struct Growth {
    Axis best;
    double least = 0;
};

/// Ends early with an axis of more than `enough`.
Growth grown(ExpandingPolytope& polytope, const Core& a, const Core& b, double slack, double enough)
{
    Growth g;
    for (int round = 0; round < most_rounds && !(g.best.gap > enough); ++round) {
        const int nearest = polytope.nearest();
        if (nearest < 0) break;
        const auto& face = polytope.face(nearest);
        g.least = face.offset;
        if (g.least + slack >= -g.best.gap) break;
        const Corner corner = extreme(a, b, face.normal);
        const double height = dot(face.normal, corner.w);
        if (-height > g.best.gap) g.best = {-height, -face.normal};
        if (height - g.least <= slack * polytope.tilt(face, corner.w) || polytope.has(corner))
            polytope.finish(nearest);
        else if (!polytope.grow(nearest, corner))
            break;
    }
    return g;
}

/// Of cores found apart: grows towards the origin, as GJK does, but forgets nothing.
Penetration distance(ExpandingPolytope& polytope, const Core& a, const Core& b, Axis best, double slack)
{
    Witness nearest = polytope.around({});
    for (int round = 0; round < most_rounds; ++round) {
        const double length = norm(nearest.v);
        if (!(length > slack)) break;
        const V3 n = (1 / length) * nearest.v;
        const Corner corner = extreme(a, b, -n);
        const double lower = dot(n, corner.w);
        if (lower > best.gap) best = {lower, n};
        if (length - best.gap <= slack || polytope.has(corner)) break;
        const int seen = polytope.brightest(corner.w);
        if (seen < 0 || !polytope.grow(seen, corner)) break;
        nearest = polytope.around({});
    }
    best.gap = gap_along(a, b, best.normal);
    return {best.gap, std::max(best.gap, norm(nearest.v)), best.normal, nearest.on_a, nearest.v};
}

Penetration expanded(const Core& a, const Core& b, double slack, double enough)
{
    Corner first[4];
    const int size = spread(a, b, slack, first);
    if (size < 4) return flat(a, b, first, size);
    ExpandingPolytope polytope(first);
    Growth g = grown(polytope, a, b, slack, enough);
    if (g.best.gap > enough) return distance(polytope, a, b, g.best, slack);
    g.best.gap = gap_along(a, b, g.best.normal);
    const double gap = std::max(g.best.gap, -g.least);
    const Witness w = polytope.around(g.best.gap > slack ? V3{} : gap * g.best.normal);
    return {g.best.gap, gap, g.best.normal, w.on_a, w.v};
}

/// With a better axis and better points, where a round core lets Newton's method find them.
Penetration polished(const Core& a, const Core& b, Penetration p, double slack)
{
    const LocalTop local = locally_best(a, b, {p.lower, p.normal}, slack);
    const Axis axis = local.axis;
    if (!(axis.gap > p.lower - slack)) return p;
    // Where they are apart, the shortest v; else the one that comes nearest to what the axis says.
    const V3 wanted = axis.gap > slack ? V3{} : axis.gap * axis.normal;
    if (norm_squared(local.v - wanted) < norm_squared(p.v - wanted)) p.point_a = local.point_a, p.v = local.v;
    p.lower = axis.gap;
    p.normal = axis.normal;
    p.gap = local.top ? axis.gap : std::max(p.gap, axis.gap);
    return p;
}

} // namespace

Penetration penetration(const Core& a, const Core& b, double slack)
{
    if (is_polytope(a) && is_polytope(b)) return expanded(a, b, slack, slack);
    Penetration p = polished(a, b, expanded(a, b, slack, infinity), slack);
    const bool touching = norm_squared(p.v) <= tolerance::contact * slack * slack;
    if (p.lower > slack && !touching) p.gap = std::max(p.lower, norm(p.v));
    return p;
}

Penetration separation_by_growth(const Core& a, const Core& b, double slack)
{
    Penetration p = expanded(a, b, slack, slack);
    if (!(p.lower > slack)) return p;
    p = polished(a, b, p, slack);
    p.gap = std::max(p.lower, norm(p.v));
    return p;
}

} // namespace brink
