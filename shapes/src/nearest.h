// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lanes.h"
#include "tolerance.h"
#include "vector.h"

#include <algorithm>

/// Nearest points in closed form. Corners are given relative to the point that asks, and the answer is the
/// vector from it to the nearest point of the feature: differences first, so nothing is lost far from the
/// origin. (Regions as in Ericson, Real-Time Collision Detection, 2005, chapter 5; the arithmetic differs.)
namespace brink {

static inline double clamp_unit(double t) { return t > 0 ? (t < 1 ? t : 1) : 0; }

/// v without its part along `edge`, which must not be zero.
static inline V3 across(V3 v, V3 edge) { return v - (dot(v, edge) / norm_squared(edge)) * edge; }

/// The nearest point of the segment from p to q.
static inline V3 to_segment(V3 p, V3 q)
{
    const V3 edge = q - p;
    const double past_p = -dot(p, edge), before_q = dot(q, edge);
    if (!(past_p > 0)) return p;
    if (!(before_q > 0)) return q;
    // From the nearer end, then once more: what rounding left along the edge would tilt a short vector.
    const double inverse = 1 / norm_squared(edge);
    const V3 v = past_p <= before_q ? p + (past_p * inverse) * edge : q - (before_q * inverse) * edge;
    return v - (dot(v, edge) * inverse) * edge;
}

/// e x f, at right angles to the longer of the two up to a few ulp; zero when they are parallel up to
/// rounding or one of them is zero. Not of unit length.
static inline V3 common_normal(V3 e, V3 f)
{
    const double ee = norm_squared(e), ff = norm_squared(f);
    const V3 n = cross(e, f);
    if (!(norm_squared(n) > tolerance::parallel * tolerance::parallel * ee * ff)) return {};
    // Rounding leaves |e||f| eps in every direction; along the longer edge it would cost eps * length / sine.
    return across(n, ee > ff ? e : f);
}

/// A triangle with its corners turned about, their order kept, until the longest edge leads from `p` to `q`.
/// What is computed from there is as good for slivers as for others: off by a few ulp of the longest edge.
struct Leaning {
    V3 p, q, apex;
};

static inline Leaning leaning(V3 a, V3 b, V3 c)
{
    const double ab = norm_squared(b - a), bc = norm_squared(c - b), ca = norm_squared(a - c);
    if (ab >= bc && ab >= ca) return {a, b, c};
    if (bc >= ca) return {b, c, a};
    return {c, a, b};
}

/// The normal of a triangle along (b - a) x (c - a), not of unit length; zero for a segment or a point.
static inline V3 face_normal(const Leaning& t)
{
    const V3 e = t.apex - t.p, f = t.apex - t.q;
    const V3 n = cross(e, f);
    const double limit = tolerance::parallel * tolerance::parallel;
    if (!(norm_squared(n) > limit * norm_squared(e) * norm_squared(f))) return {};
    return across(n, t.q - t.p);
}
static inline V3 face_normal(V3 a, V3 b, V3 c) { return face_normal(leaning(a, b, c)); }

static inline V3 shorter(V3 a, V3 b) { return norm_squared(b) < norm_squared(a) ? b : a; }

/// The nearest point of the triangle.
static inline V3 to_triangle(V3 a, V3 b, V3 c)
{
    const Leaning t = leaning(a, b, c);
    const V3 base = t.q - t.p, side = t.apex - t.p, normal = face_normal(t);
    const double square = norm_squared(normal);
    if (square > 0) {
        // How far the foot of the perpendicular lies towards the apex, then how far along the base that
        // leaves.
        const V3 height = across(side, base);
        const double up = -dot(across(t.p, base), height) / norm_squared(height);
        const double on = -dot(t.p + up * side, base) / norm_squared(base);
        if (up >= 0 && on >= 0 && up + on <= 1) {
            const V3 inside = t.p + on * base + up * side, foot = (dot(normal, t.p) / square) * normal;
            const double scale = norm_squared(a) + norm_squared(b) + norm_squared(c);
            // The latter is truer in direction, but slips off the face of a sliver.
            return norm_squared(inside - foot) <= tolerance::tight * tolerance::tight * scale ? foot : inside;
        }
    }
    return shorter(shorter(to_segment(a, b), to_segment(b, c)), to_segment(c, a));
}

/// From a point in a box's own frame to its nearest of the box; zero inside.
static inline V3 to_box(V3 p, V3 half_extents)
{
    const V3 h = half_extents;
    return {std::clamp(p.x, -h.x, h.x) - p.x, std::clamp(p.y, -h.y, h.y) - p.y,
            std::clamp(p.z, -h.z, h.z) - p.z};
}

/// Where the segment from p along d comes nearest to a box about the origin, as a fraction of it: where the
/// slope of the squared distance, which never falls and is straight between the planes of the box's sides,
/// passes zero.
static inline double nearest_to_box(V3 p, V3 d, V3 h)
{
    const auto part = [](Two t, double from, double by, double half) {
        const Two x = both(from) + t * both(by);
        return both(by) * (larger(x - both(half), Two{}) + smaller(x + both(half), Two{}));
    };
    const auto slope = [&](Two t) {
        return part(t, p.x, d.x, h.x) + part(t, p.y, d.y, h.y) + part(t, p.z, d.z, h.z);
    };
    const Two ends = slope(Two{0, 1});
    if (!(ends[0] < 0)) return 0;
    if (!(ends[1] > 0)) return 1;
    Two low{}, high = both(1), at_low = both(ends[0]), at_high = both(ends[1]);
    const auto cut = [&](double from, double by, double half) {
        const Two t = smaller(larger((Two{-half, half} - both(from)) / both(by), Two{}), both(1)),
                  at = slope(t);
        const TwoFlags before = (at <= Two{}) & (t > low), after = (at >= Two{}) & (t < high);
        low = select(before, t, low);
        at_low = select(before, at, at_low);
        high = select(after, t, high);
        at_high = select(after, at, at_high);
    };
    cut(p.x, d.x, h.x);
    cut(p.y, d.y, h.y);
    cut(p.z, d.z, h.z);
    const int l = low[1] > low[0] ? 1 : 0, u = high[1] < high[0] ? 1 : 0;
    const double rise = at_high[u] - at_low[l], way = high[u] - low[l];
    return low[l] + (rise > 0 ? -at_low[l] / rise : 0.5) * way;
}

struct Parameters {
    double on_a, on_b;
};

/// Where two segments come nearest, as fractions of each: A's starts at the origin along d, B's at r along e.
static inline Parameters nearest_parameters(V3 r, V3 d, V3 e)
{
    const double dd = norm_squared(d), ee = norm_squared(e), de = dot(d, e);
    const double inverse_d = dd > 0 ? 1 / dd : 0, inverse_e = ee > 0 ? 1 / ee : 0;
    // The lines, in cross products: their rounding grows as 1 / sine of the angle and not as its square.
    const V3 n = cross(d, e);
    const double nn = norm_squared(n), limit = tolerance::parallel * tolerance::parallel;
    const double on_line = nn > limit * dd * ee ? clamp_unit(dot(cross(r, e), n) / nn) : 0;
    // Past an end of one, the nearest point of the other moves: two projections settle it.
    const double t = clamp_unit((on_line * de - dot(r, e)) * inverse_e);
    return {clamp_unit((t * de + dot(r, d)) * inverse_d), t};
}

} // namespace brink
