// SPDX-License-Identifier: BSD-3-Clause
#include "bracket.h"
#if BRINK_HAVE_REFEREE
#include "hundred.h"
#endif

#include <algorithm>

namespace brink::support {
namespace {

template <class T> T clamped(const T& x) { return x < 0 ? T(0) : x > 1 ? T(1) : x; }

template <class T> struct Keeper {
    NearestPoints<T> best;
    T squared = -1;

    void keep(const Vector<T>& a, const Vector<T>& b)
    {
        const Vector<T> between = b - a;
        const T here = dot(between, between);
        if (squared >= 0 && here >= squared) return;
        squared = here;
        best = {a, b};
    }
};

/// The nearest points of the segments p + s u and q + t v, s and t in [0, 1] (C. Ericson, Real-Time Collision
/// Detection, 2005, section 5.1.9).
template <class T>
void keep_edges(Keeper<T>& keeper, const Vector<T>& p, const Vector<T>& u, const Vector<T>& q,
                const Vector<T>& v)
{
    const Vector<T> r = p - q;
    const T uu = dot(u, u);
    const T vv = dot(v, v);
    const T ur = dot(u, r);
    const T vr = dot(v, r);
    T s = 0;
    T t = 0;
    if (uu > 0 && vv > 0) {
        const T uv = dot(u, v);
        const T bent = uu * vv - uv * uv;
        if (bent > 0) s = clamped(T((uv * vr - ur * vv) / bent));
        t = (uv * s + vr) / vv;
        if (t < 0) s = clamped(T(-ur / uu));
        if (t > 1) s = clamped(T((uv - ur) / uu));
        t = clamped(t);
    } else if (uu > 0) {
        s = clamped(T(-ur / uu));
    } else if (vv > 0) {
        t = clamped(T(vr / vv));
    }
    keeper.keep(p + s * u, q + t * v);
}

/// u x v, at right angles to the longer of the two as nearly as to the other: along that one, what rounding
/// leaves of a needle's tilts the normal over all of its length.
template <class T> Vector<T> common_normal(const Vector<T>& u, const Vector<T>& v)
{
    const Vector<T> n = cross(u, v);
    const Vector<T> longer = dot(u, u) < dot(v, v) ? v : u;
    const T square = dot(longer, longer);
    return square > 0 ? Vector<T>(n - T(dot(n, longer) / square) * longer) : n;
}

/// The foot of a corner on a face, where it lies in the face.
template <class T> struct Panel {
    Vector<T> at, u, v, normal;
    T weight = 0;
    bool whole = false;

    Panel(const Placement<T>& body, const typename Solid<T>::Face& face)
        : at(body.corners[face.at]),
          u(body.corners[face.u] - at),
          v(body.corners[face.v] - at),
          normal(common_normal(u, v)),
          weight(dot(normal, normal)),
          whole(face.whole)
    {
    }

    bool foot(const Vector<T>& point, Vector<T>& out) const
    {
        if (weight == 0) return false;
        const Vector<T> w = point - at;
        const T s = dot(cross(w, v), normal) / weight;
        const T t = dot(cross(u, w), normal) / weight;
        const bool inside = s >= 0 && t >= 0 && (whole ? s <= 1 && t <= 1 : s + t <= 1);
        if (inside) out = at + s * u + t * v;
        return inside;
    }
};

template <class T>
Depth<T> keep_axis(Depth<T> best, const Placement<T>& a, const Placement<T>& b, const Vector<T>& axis)
{
    const T weight = dot(axis, axis);
    if (weight == 0) return best;
    using std::sqrt;
    const Vector<T> n = T(1 / sqrt(weight)) * axis;
    const T high_a = dot(n, a.support(n));
    const T low_a = dot(n, a.support(-n));
    const T high_b = dot(n, b.support(n));
    const T low_b = dot(n, b.support(-n));
    const T along = low_b - high_a;
    const T against = low_a - high_b;
    const bool none = dot(best.normal, best.normal) == 0;
    if (none || along > best.along) best = {along, n};
    if (against > best.along) best = {against, -n};
    return best;
}

} // namespace

template <class T> NearestPoints<T> nearest_features(const Placement<T>& a, const Placement<T>& b)
{
    Keeper<T> keeper;
    for (const auto& edge_a : a.solid->edges)
        for (const auto& edge_b : b.solid->edges)
            keep_edges(keeper, a.corners[edge_a.from], a.corners[edge_a.to] - a.corners[edge_a.from],
                       b.corners[edge_b.from], b.corners[edge_b.to] - b.corners[edge_b.from]);
    Vector<T> foot;
    for (const auto& face : a.solid->faces) {
        const Panel<T> panel(a, face);
        for (const Vector<T>& corner : b.corners)
            if (panel.foot(corner, foot)) keeper.keep(foot, corner);
    }
    for (const auto& face : b.solid->faces) {
        const Panel<T> panel(b, face);
        for (const Vector<T>& corner : a.corners)
            if (panel.foot(corner, foot)) keeper.keep(corner, foot);
    }
    return keeper.best;
}

template <class T> Depth<T> separating_axis(const Placement<T>& a, const Placement<T>& b)
{
    Depth<T> best;
    for (const Placement<T>* body : {&a, &b})
        for (const auto& face : body->solid->faces)
            best = keep_axis(best, a, b, Panel<T>(*body, face).normal);
    for (const auto& edge_a : a.solid->edges)
        for (const auto& edge_b : b.solid->edges)
            best = keep_axis(best, a, b,
                             common_normal<T>(a.corners[edge_a.to] - a.corners[edge_a.from],
                                              b.corners[edge_b.to] - b.corners[edge_b.from]));
    return best;
}

template NearestPoints<long double> nearest_features(const Placement<long double>&,
                                                     const Placement<long double>&);
template Depth<long double> separating_axis(const Placement<long double>&, const Placement<long double>&);
#if BRINK_HAVE_REFEREE
template NearestPoints<Hundred> nearest_features(const Placement<Hundred>&, const Placement<Hundred>&);
template Depth<Hundred> separating_axis(const Placement<Hundred>&, const Placement<Hundred>&);
#endif

} // namespace brink::support
