// SPDX-License-Identifier: BSD-3-Clause
#include "bracket.h"
#if BRINK_HAVE_REFEREE
#include "hundred.h"
#endif

namespace brink::support {
namespace {

template <class T> bool polytope(const Placement<T>& p) { return p.solid->core == Core::polytope; }

/// A supporting plane this much short of the distance says that the polytopes overlap, or are so near that
/// the direction between their nearest points is rounding.
template <class T> bool falls_short(const T& lower, const T& upper) { return lower < T(0.999) * upper; }

template <class T> Bracket<T> between_polytopes(const Placement<T>& a, const Placement<T>& b, const T& radii)
{
    const NearestPoints<T> near = nearest_features(a, b);
    const Vector<T> between = near.b - near.a;
    const T length = norm(between);
    Bracket<T> out;
    out.upper = length - radii;
    out.lower = -radii;
    out.point_a = near.a;
    out.point_b = near.b;
    out.points_known = true;
    if (length > 0) {
        out.normal = T(1 / length) * between;
        out.lower = separation(a, b, out.normal);
    }
    if (length > 0 && !falls_short(T(out.lower + radii), length)) return out;
    const Depth<T> deep = separating_axis(a, b);
    if (deep.along <= 0 && dot(deep.normal, deep.normal) > 0) {
        out.upper = deep.along - radii;
        out.points_known = false;
    }
    if (deep.along - radii >= out.lower || deep.along <= 0) {
        out.lower = deep.along - radii;
        out.normal = deep.normal;
    }
    return out;
}

template <class T>
Bracket<T> between_cores(const Placement<T>& a, const Placement<T>& b, const T& radii, const T& enough,
                         const Vector<T>& hint)
{
    const Simplices<T> found = by_simplices(a, b, enough, hint);
    Bracket<T> out;
    out.upper = found.upper - radii;
    out.lower = found.lower - radii;
    out.normal = found.normal;
    out.point_a = found.point_a;
    out.point_b = found.point_b;
    out.points_known = !found.overlap;
    out.depth_known = !found.overlap;
    if (found.overlap) out.lower = out.upper = -radii;
    return out;
}

template <class T> Bracket<T> over_ground(const Placement<T>& body, const Placement<T>& ground)
{
    const GroundHeights<T> h = heights_over(body, ground);
    const bool under = ground.solid->core == Core::plane && h.below > h.above;
    const Vector<T>& at = under ? h.highest : h.lowest;
    Bracket<T> out;
    out.lower = out.upper = under ? h.below : h.above;
    out.normal = under ? ground.normal : -ground.normal;
    out.point_a = at;
    out.point_b = at - T(dot(ground.normal, at) - ground.offset) * ground.normal;
    out.points_known = true;
    return out;
}

} // namespace

template <class T> T separation(const Placement<T>& a, const Placement<T>& b, const Vector<T>& n)
{
    return dot(n, b.support(-n)) - dot(n, a.support(n)) - a.solid->radius - b.solid->radius;
}

template <class T> GroundHeights<T> heights_over(const Placement<T>& body, const Placement<T>& ground)
{
    GroundHeights<T> out;
    out.lowest = body.support(-ground.normal);
    out.highest = body.support(ground.normal);
    out.above = dot(ground.normal, out.lowest) - ground.offset - body.solid->radius;
    out.below = ground.offset - dot(ground.normal, out.highest) - body.solid->radius;
    return out;
}

template <class T>
Bracket<T> bracket(const Placement<T>& a, const Placement<T>& b, const T& enough, const Vector<T>& hint)
{
    if (b.solid->unbounded()) return over_ground(a, b);
    if (a.solid->unbounded()) {
        Bracket<T> out = over_ground(b, a);
        std::swap(out.point_a, out.point_b);
        out.normal = -out.normal;
        return out;
    }
    const T radii = a.solid->radius + b.solid->radius;
    if (polytope(a) && polytope(b)) return between_polytopes(a, b, radii);
    return between_cores(a, b, radii, enough, hint);
}

template long double separation(const Placement<long double>&, const Placement<long double>&,
                                const Vector<long double>&);
template GroundHeights<long double> heights_over(const Placement<long double>&,
                                                 const Placement<long double>&);
template Bracket<long double> bracket(const Placement<long double>&, const Placement<long double>&,
                                      const long double&, const Vector<long double>&);
#if BRINK_HAVE_REFEREE
template Hundred separation(const Placement<Hundred>&, const Placement<Hundred>&, const Vector<Hundred>&);
template GroundHeights<Hundred> heights_over(const Placement<Hundred>&, const Placement<Hundred>&);
template Bracket<Hundred> bracket(const Placement<Hundred>&, const Placement<Hundred>&, const Hundred&,
                                  const Vector<Hundred>&);
#endif

} // namespace brink::support
