// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brute_force.h"
#include "simplex.h"

#include <initializer_list>
#include <limits>

/// Simplices by hand, and what long doubles tell of them.
namespace brink::simplices {

using brute::R3;
using brute::real;
using brute::Real;

inline constexpr double eps = std::numeric_limits<double>::epsilon();

inline Simplex simplex_of(std::initializer_list<V3> points)
{
    Simplex s;
    for (const V3 p : points)
        s.add({p, {}, p, s.size, s.size, 0});
    return s;
}

inline V3 nearest_point(const Simplex& s) { return s.nearest_point(s.nearest(Simplex::Origin::anywhere)); }

inline double weight_sum(const Simplex& s)
{
    double sum = 0;
    for (int k = 0; k < s.size; ++k)
        sum += s.corners[k].weight;
    return sum;
}

inline double scale(const Simplex& s)
{
    double largest = 0;
    for (int k = 0; k < s.size; ++k)
        largest = std::max(largest, norm(s.corners[k].w));
    return largest;
}

/// How far the hull of the corners is from the origin, if that is not inside.
inline Real distance(const Simplex& s)
{
    Real least = infinity;
    for (int i = 0; i < s.size; ++i)
        for (int j = 0; j <= i; ++j)
            for (int k = 0; k <= j; ++k) {
                const R3 a = real(s.corners[i].w), b = real(s.corners[j].w), c = real(s.corners[k].w);
                least = std::min({least, brute::to_segment({}, {a, b}), brute::to_face({}, {a, b, c})});
            }
    return least;
}

inline Real volume(R3 a, R3 b, R3 c, R3 d) { return brute::dot(brute::cross(b - a, c - a), d - a); }

/// The least of the origin's distances from the four faces, negative where it is beyond that face; not for
/// flat ones.
inline Real depth(const Simplex& s)
{
    Real least = infinity;
    for (int k = 0; k < 4; ++k) {
        const R3 a = real(s.corners[k].w), b = real(s.corners[(k + 1) % 4].w);
        const R3 c = real(s.corners[(k + 2) % 4].w), d = real(s.corners[(k + 3) % 4].w);
        const Real inwards = volume(a, b, c, d) < 0 ? -1 : 1;
        least = std::min(least, inwards * volume({}, b, c, d) / brute::norm(brute::cross(c - b, d - b)));
    }
    return least;
}

} // namespace brink::simplices
