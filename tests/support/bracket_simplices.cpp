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

/// Where the plane of a face, or the line of an edge, that has the newest corner at p and the sides s comes
/// nearest to the origin, and the sides' weights there. By products of sides, not by normal equations, which
/// square what is lost on long thin faces. False where the sides are parallel.
template <class T> struct Foot {
    Vector<T> at;
    std::array<T, 3> weight;

    bool find(const Vector<T>& p, const std::array<Vector<T>, 3>& s, std::size_t n)
    {
        if (n == 0) at = p;
        if (n == 1) return on_line(p, s[0]);
        if (n == 2) return on_plane(p, s[0], s[1]);
        return n == 0 || in_space(p, s[0], s[1], s[2]);
    }

private:
    bool on_line(const Vector<T>& p, const Vector<T>& s)
    {
        const T length = dot(s, s);
        if (length == 0) return false;
        weight[0] = -dot(s, p) / length;
        at = p + weight[0] * s;
        return true;
    }
    bool on_plane(const Vector<T>& p, const Vector<T>& s, const Vector<T>& r)
    {
        const Vector<T> m = cross(s, r);
        const T area = dot(m, m);
        if (area == 0) return false;
        weight[0] = dot(cross(r, p), m) / area;
        weight[1] = dot(cross(p, s), m) / area;
        at = T(dot(m, p) / area) * m;
        return true;
    }
    bool in_space(const Vector<T>& p, const Vector<T>& s, const Vector<T>& r, const Vector<T>& q)
    {
        const T volume = triple(s, r, q);
        if (volume == 0) return false;
        weight = {-triple(p, r, q) / volume, -triple(s, p, q) / volume, -triple(s, r, p) / volume};
        at = {};
        return true;
    }
};

/// Takes the face of the corners `which` besides the newest if it is nearer and holds its foot.
template <class T>
void keep_nearer(Face<T>& best, const Simplex<T>& s, const std::array<std::size_t, 3>& which, std::size_t n)
{
    const Corner<T>& newest = s.corner[s.count - 1];
    std::array<Vector<T>, 3> side;
    for (std::size_t i = 0; i < n; ++i)
        side[i] = s.corner[which[i]].p - newest.p;
    Foot<T> foot;
    if (!foot.find(newest.p, side, n)) return;
    T rest = 1;
    for (std::size_t i = 0; i < n; ++i) {
        if (foot.weight[i] < 0) return;
        rest -= foot.weight[i];
    }
    const T squared = dot(foot.at, foot.at);
    if (rest < 0 || (best.squared >= 0 && squared >= best.squared)) return;
    best = {{}, foot.at, newest.a, newest.b, squared};
    for (std::size_t i = 0; i < n; ++i) {
        const Corner<T>& c = s.corner[which[i]];
        best.a = best.a + foot.weight[i] * (c.a - newest.a);
        best.b = best.b + foot.weight[i] * (c.b - newest.b);
        best.simplex.corner[best.simplex.count++] = c;
    }
    best.simplex.corner[best.simplex.count++] = newest;
}

/// Looks at every face that has the newest corner, which is the last.
template <class T> Face<T> nearest_face(const Simplex<T>& s)
{
    const std::size_t others = s.count - 1;
    Face<T> best;
    for (std::size_t mask = 0; mask < (std::size_t{1} << others); ++mask) {
        std::array<std::size_t, 3> which{};
        std::size_t n = 0;
        for (std::size_t i = 0; i < others; ++i)
            if ((mask >> i & 1U) != 0) which[n++] = i;
        keep_nearer(best, s, which, n);
    }
    return best;
}

template <class T> bool has(const Simplex<T>& s, const Vector<T>& p)
{
    for (std::size_t i = 0; i < s.count; ++i)
        if (s.corner[i].p.x == p.x && s.corner[i].p.y == p.y && s.corner[i].p.z == p.z) return true;
    return false;
}

template <class T> bool narrow(const Simplices<T>& found, const Effort<T>& effort)
{
    const T width = found.upper - found.lower;
    const bool touching = effort.share > 0 && found.upper <= effort.level;
    return touching || width <= effort.enough || width <= effort.share * (found.lower - effort.level);
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
Simplices<T> by_simplices(const Placement<T>& a, const Placement<T>& b, const Effort<T>& effort)
{
    using std::sqrt;
    const auto corner = [&](const Vector<T>& n) {
        Corner<T> out{{}, a.support(n), b.support(-n)};
        out.p = out.b - out.a;
        return out;
    };
    Simplices<T> out;
    Simplex<T> simplex;
    simplex.corner[simplex.count++] = corner(first_direction(a, b, effort.hint));
    bool any = false;
    int idle = 0;
    for (int i = 0; i < most_iterations<T> && idle < most_idle; ++i) {
        const Face<T> face = nearest_face(simplex);
        if (face.squared < 0) break;
        const T length = sqrt(face.squared);
        const T apart = norm(face.b - face.a);
        const bool gained = !any || apart < out.upper;
        idle = gained ? 0 : idle + 1;
        if (gained) {
            out.upper = apart;
            out.point_a = face.a;
            out.point_b = face.b;
        }
        simplex = face.simplex;
        out.overlap = simplex.count == 4 || length == 0;
        if (out.overlap && any && out.lower > 0) { // a plane between them has said no: a sliver of rounding
            out.overlap = false;
            break;
        }
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
        if (narrow(out, effort) || has(simplex, next.p)) break;
        simplex.corner[simplex.count++] = next;
    }
    return out;
}

template Simplices<long double> by_simplices(const Placement<long double>&, const Placement<long double>&,
                                             const Effort<long double>&);
#if BRINK_HAVE_REFEREE
template Simplices<Hundred> by_simplices(const Placement<Hundred>&, const Placement<Hundred>&,
                                         const Effort<Hundred>&);
#endif

} // namespace brink::support
