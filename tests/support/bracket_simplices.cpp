// SPDX-License-Identifier: BSD-3-Clause
#include "bracket.h"
#if BRINK_HAVE_REFEREE
#include "hundred.h"
#endif

#include <array>
#include <limits>
#include <type_traits>

namespace brink::support {
namespace {

/// Iterations after which the bounds are taken as they are, and how many may pass without a gain.
template <class T> constexpr int most_iterations = std::is_floating_point_v<T> ? 100 : 600;
constexpr int most_idle = 4;

/// A point of the difference of the cores, B's less A's.
template <class T> struct Corner {
    Vector<T> p, a, b;
};

template <class T> struct Simplex {
    std::array<Corner<T>, 4> corner;
    std::size_t count = 0;
};

/// The point of a simplex that is nearest to the origin, on the smallest face that has it.
template <class T> struct Face {
    Simplex<T> simplex;
    Vector<T> p, a, b;
    T squared = -1;
};

template <class T> T triple(const Vector<T>& a, const Vector<T>& b, const Vector<T>& c)
{
    return dot(a, cross(b, c));
}

/// The weights of newest + sum of weight * side, least in norm: normal equations by Cramer's rule. False
/// where they have no one solution.
template <class T>
bool solve(const std::array<std::array<T, 3>, 3>& gram, const std::array<T, 3>& right, std::size_t n,
           std::array<T, 3>& weight)
{
    const auto& g = gram;
    if (n == 1) {
        if (g[0][0] <= 0) return false;
        weight[0] = right[0] / g[0][0];
        return true;
    }
    if (n == 2) {
        const T det = g[0][0] * g[1][1] - g[0][1] * g[0][1];
        if (det <= 0) return false;
        weight[0] = (right[0] * g[1][1] - right[1] * g[0][1]) / det;
        weight[1] = (right[1] * g[0][0] - right[0] * g[0][1]) / det;
        return true;
    }
    const Vector<T> x{g[0][0], g[0][1], g[0][2]};
    const Vector<T> y{g[1][0], g[1][1], g[1][2]};
    const Vector<T> z{g[2][0], g[2][1], g[2][2]};
    const Vector<T> r{right[0], right[1], right[2]};
    const T det = triple(x, y, z);
    if (det <= 0) return false;
    weight = {triple(r, y, z) / det, triple(x, r, z) / det, triple(x, y, r) / det};
    return true;
}

/// Looks at every face that has the newest corner, which is the last.
template <class T> Face<T> nearest_face(const Simplex<T>& s)
{
    const Corner<T>& newest = s.corner[s.count - 1];
    const std::size_t others = s.count - 1;
    std::array<Vector<T>, 3> side;
    std::array<std::array<T, 3>, 3> all;
    std::array<T, 3> onto;
    for (std::size_t i = 0; i < others; ++i) {
        side[i] = s.corner[i].p - newest.p;
        onto[i] = -dot(side[i], newest.p);
    }
    for (std::size_t i = 0; i < others; ++i)
        for (std::size_t j = i; j < others; ++j)
            all[i][j] = all[j][i] = dot(side[i], side[j]);
    Face<T> best;
    for (std::size_t mask = 0; mask < (std::size_t{1} << others); ++mask) {
        std::array<std::size_t, 3> which{};
        std::size_t n = 0;
        for (std::size_t i = 0; i < others; ++i)
            if ((mask >> i & 1U) != 0) which[n++] = i;
        std::array<std::array<T, 3>, 3> gram;
        std::array<T, 3> right;
        std::array<T, 3> weight;
        for (std::size_t i = 0; i < n; ++i) {
            right[i] = onto[which[i]];
            for (std::size_t j = 0; j < n; ++j)
                gram[i][j] = all[which[i]][which[j]];
        }
        if (n > 0 && !solve(gram, right, n, weight)) continue;
        T rest = 1;
        bool inside = true;
        Vector<T> p = newest.p;
        for (std::size_t i = 0; i < n; ++i) {
            rest -= weight[i];
            inside = inside && weight[i] >= 0;
            p = p + weight[i] * side[which[i]];
        }
        const T squared = dot(p, p);
        if (!inside || rest < 0 || (best.squared >= 0 && squared >= best.squared)) continue;
        best.squared = squared;
        best.p = p;
        best.a = newest.a;
        best.b = newest.b;
        best.simplex.count = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const Corner<T>& c = s.corner[which[i]];
            best.a = best.a + weight[i] * (c.a - newest.a);
            best.b = best.b + weight[i] * (c.b - newest.b);
            best.simplex.corner[best.simplex.count++] = c;
        }
        best.simplex.corner[best.simplex.count++] = newest;
    }
    return best;
}

template <class T> bool has(const Simplex<T>& s, const Vector<T>& p)
{
    for (std::size_t i = 0; i < s.count; ++i)
        if (s.corner[i].p.x == p.x && s.corner[i].p.y == p.y && s.corner[i].p.z == p.z) return true;
    return false;
}

template <class T>
Vector<T> first_direction(const Placement<T>& a, const Placement<T>& b, const Vector<T>& hint)
{
    if (dot(hint, hint) > 0) return hint;
    const Vector<T> between = b.origin - a.origin;
    return dot(between, between) > 0 ? between : Vector<T>{1, 0, 0};
}

} // namespace

template <class T>
Simplices<T> by_simplices(const Placement<T>& a, const Placement<T>& b, const T& enough,
                          const Vector<T>& hint)
{
    using std::sqrt;
    const auto corner = [&](const Vector<T>& n) {
        Corner<T> out{{}, a.support(n), b.support(-n)};
        out.p = out.b - out.a;
        return out;
    };
    Simplices<T> out;
    Simplex<T> simplex;
    simplex.corner[simplex.count++] = corner(first_direction(a, b, hint));
    bool any = false;
    int idle = 0;
    for (int i = 0; i < most_iterations<T> && idle < most_idle; ++i) {
        const Face<T> face = nearest_face(simplex);
        if (face.squared < 0) break;
        const T length = sqrt(face.squared);
        const bool gained = !any || length < out.upper;
        idle = gained ? 0 : idle + 1;
        if (gained) {
            out.upper = length;
            out.point_a = face.a;
            out.point_b = face.b;
        }
        simplex = face.simplex;
        out.overlap = simplex.count == 4 || length == 0;
        if (out.overlap) return out;
        const Vector<T> n = T(1 / length) * face.p;
        const Corner<T> next = corner(n);
        const T lower = dot(n, next.p);
        if (!any || lower > out.lower) {
            out.lower = lower;
            out.normal = n;
            idle = 0;
        }
        any = true;
        if (out.upper - out.lower <= enough || has(simplex, next.p)) break;
        simplex.corner[simplex.count++] = next;
    }
    return out;
}

template Simplices<long double> by_simplices(const Placement<long double>&, const Placement<long double>&,
                                             const long double&, const Vector<long double>&);
#if BRINK_HAVE_REFEREE
template Simplices<Hundred> by_simplices(const Placement<Hundred>&, const Placement<Hundred>&, const Hundred&,
                                         const Vector<Hundred>&);
#endif

} // namespace brink::support
