// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solid.h"

/// The gap between two placed solids, with its proof: two points that exist bound it from above and two
/// supporting planes from below. However a nearest pair was found, the bounds are what they are.
namespace brink::support {

template <class T> struct Bracket {
    T lower = 0, upper = 0;     // of the signed gap, radii counted
    Vector<T> normal;           // unit, from A to B: of the supporting planes; zero where there is none
    Vector<T> point_a, point_b; // the nearest points of the cores
    bool points_known = false;  // not where the cores overlap
    bool depth_known = true;    // false: the cores overlap, and how deep is not known
};

/// At most one may be unbounded. Polytopes by brute force over features (overlap: by separating axes, with
/// the depth); the others by GJK (E. Gilbert, D. Johnson, S. Keerthi 1988) until the bounds are within
/// `enough` (a length) or the arithmetic is exhausted. `hint`: a direction from A to B to start from, if one
/// is known. For T = long double the bounds are subject to rounding.
template <class T>
Bracket<T> bracket(const Placement<T>& a, const Placement<T>& b, const T& enough,
                   const Vector<T>& hint = Vector<T>{});

/// The least of n . b - n . a over the cores of two bounded solids, less the radii: not above the gap for a
/// unit normal.
template <class T> T separation(const Placement<T>& a, const Placement<T>& b, const Vector<T>& n);

/// How far a bounded solid is above unbounded ground, along the ground's normal, and below it; negative where
/// it is not.
template <class T> struct GroundHeights {
    T above, below;
    Vector<T> lowest, highest; // points of the core
};
template <class T> GroundHeights<T> heights_over(const Placement<T>& body, const Placement<T>& ground);

/// The nearest points of two polytopes, each on a feature: every edge against every edge, every corner
/// against every face. Where the polytopes overlap they mean nothing.
template <class T> struct NearestPoints {
    Vector<T> a, b;
};
template <class T> NearestPoints<T> nearest_features(const Placement<T>& a, const Placement<T>& b);

/// The greatest separation over the axes along which two polytopes can part (the normals of faces and the
/// products of edges): minus the depth where they overlap. Zero, without a normal, where there is no such
/// axis.
template <class T> struct Depth {
    T along = 0;
    Vector<T> normal;
};
template <class T> Depth<T> separating_axis(const Placement<T>& a, const Placement<T>& b);

/// The nearest points of any two bounded cores by GJK. Radii do not count.
template <class T> struct Simplices {
    T lower = 0, upper = 0;
    Vector<T> normal, point_a, point_b;
    bool overlap = false; // four points of the difference of the cores hold the origin
};
template <class T>
Simplices<T> by_simplices(const Placement<T>& a, const Placement<T>& b, const T& enough,
                          const Vector<T>& hint);

} // namespace brink::support
