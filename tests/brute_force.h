// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"
#include "random.h"
#include "support.h"

#include <algorithm>
#include <cmath>
#include <vector>

/// Distances of cores (radii left out) the long way round, in long double: every corner against every face,
/// every edge against every edge, every axis. No cleverness, and of the library only where a core has its
/// corners.
namespace brink::brute {

using Real = long double;

struct R3 {
    Real x = 0, y = 0, z = 0;
};
inline R3 operator+(R3 a, R3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline R3 operator-(R3 a, R3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline R3 operator*(Real s, R3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline Real dot(R3 a, R3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline R3 cross(R3 a, R3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline Real norm(R3 a) { return std::sqrt(dot(a, a)); }
inline R3 real(V3 v) { return {v.x, v.y, v.z}; }
inline R3 unit(R3 a) { return norm(a) > 0 ? (1 / norm(a)) * a : a; }
/// v without its part along the unit vector n; twice, for what rounding leaves.
inline R3 across(R3 v, R3 n)
{
    v = v - dot(v, n) * n;
    return v - dot(v, n) * n;
}

struct Edge {
    R3 from, to;
};
struct Face {
    R3 a, b, c; // a triangle
};
struct Polytope {
    std::vector<R3> corners;
    std::vector<Edge> edges;
    std::vector<Face> faces;
};

inline Polytope polytope(const Core& core)
{
    Polytope p;
    for (int k = 0; k < core.count; ++k)
        p.corners.push_back(real(corner(core, k)));
    const auto& c = p.corners;
    if (core.kind == Core::Kind::segment) p.edges = {{c[0], c[1]}};
    if (core.kind == Core::Kind::triangle) {
        p.edges = {{c[0], c[1]}, {c[1], c[2]}, {c[2], c[0]}};
        p.faces = {{c[0], c[1], c[2]}};
    }
    if (core.kind != Core::Kind::box) return p;
    for (unsigned k = 0; k < 8; ++k)
        for (const unsigned bit : {1U, 2U, 4U})
            if ((k & bit) == 0) p.edges.push_back({c[k], c[k | bit]});
    for (const unsigned bit : {1U, 2U, 4U}) {
        const unsigned u = bit == 1 ? 2 : 1, v = bit == 4 ? 2 : 4;
        for (const unsigned side : {0U, bit}) {
            p.faces.push_back({c[side], c[side | u], c[side | v]});
            p.faces.push_back({c[side | u | v], c[side | u], c[side | v]});
        }
    }
    return p;
}

inline Real to_segment(R3 p, const Edge& e)
{
    const R3 along = e.to - e.from;
    const Real square = dot(along, along);
    const Real t = square > 0 ? std::clamp(dot(p - e.from, along) / square, Real{0}, Real{1}) : Real{0};
    return norm(e.from + t * along - p);
}

inline Real edge_edge(const Edge& e, const Edge& f)
{
    const Real ends =
        std::min({to_segment(e.from, f), to_segment(e.to, f), to_segment(f.from, e), to_segment(f.to, e)});
    const R3 u = e.to - e.from, v = f.to - f.from, n = cross(u, v), r = f.from - e.from;
    const Real square = dot(n, n);
    if (!(square > 0)) return ends;
    const Real s = dot(cross(r, v), n) / square, t = dot(cross(r, u), n) / square;
    if (s < 0 || s > 1 || t < 0 || t > 1) return ends;
    return std::min(ends, norm(r + t * v - s * u));
}

/// In a frame whose first axis is the longest edge; infinite where the foot is outside.
inline Real to_face(R3 p, Face f)
{
    for (int turn = 0; turn < 2; ++turn)
        if (norm(f.b - f.a) < std::max(norm(f.c - f.b), norm(f.a - f.c))) f = {f.b, f.c, f.a};
    const R3 x = unit(f.b - f.a), side = f.c - f.a, upright = across(side, x), y = unit(upright), q = p - f.a;
    const Real base = norm(f.b - f.a), height = norm(upright), lean = dot(side, x);
    if (!(height > 1e-17L * base)) return infinity; // a segment, or a point
    const Real up = dot(q, y) / height, on = (dot(q, x) - up * lean) / base;
    constexpr Real seam = 1e-17L; // a rectangle's two halves leave no gap between them
    return up >= -seam && on >= -seam && up + on <= 1 + seam ? std::fabs(dot(q, cross(x, y)))
                                                             : Real{infinity};
}

/// The distance, when the two are apart.
inline Real features(const Polytope& a, const Polytope& b)
{
    Real least = infinity;
    for (const R3 p : a.corners) {
        for (const R3 q : b.corners)
            least = std::min(least, norm(p - q));
        for (const Edge& e : b.edges)
            least = std::min(least, to_segment(p, e));
        for (const Face& f : b.faces)
            least = std::min(least, to_face(p, f));
    }
    for (const R3 q : b.corners) {
        for (const Edge& e : a.edges)
            least = std::min(least, to_segment(q, e));
        for (const Face& f : a.faces)
            least = std::min(least, to_face(q, f));
    }
    for (const Edge& e : a.edges)
        for (const Edge& f : b.edges)
            least = std::min(least, edge_edge(e, f));
    return least;
}

/// The gap between the planes that support both at right angles to n.
inline Real along(const Polytope& a, const Polytope& b, R3 n)
{
    n = unit(n);
    Real high = -infinity, low = infinity;
    for (const R3 p : a.corners)
        high = std::max(high, dot(n, p));
    for (const R3 q : b.corners)
        low = std::min(low, dot(n, q));
    return low - high;
}

/// Axes enough for flat ones too: face normals, edge x edge, and across every edge.
inline std::vector<R3> axes(const Polytope& a, const Polytope& b)
{
    std::vector<R3> all{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const Polytope* p : {&a, &b}) {
        for (const Face& f : p->faces) {
            R3 n = cross(f.b - f.a, f.c - f.a);
            for (const R3 e : {f.b - f.a, f.c - f.b, f.a - f.c})
                n = across(n, unit(e));
            all.push_back(n);
        }
        for (const Edge& e : p->edges)
            for (const R3 x : {R3{1, 0, 0}, R3{0, 1, 0}, R3{0, 0, 1}})
                all.push_back(cross(e.to - e.from, x));
    }
    for (const Edge& e : a.edges)
        for (const Edge& f : b.edges) {
            const R3 u = e.to - e.from;
            all.push_back(across(cross(u, f.to - f.from), unit(u)));
        }
    return all;
}

inline Real best_axis(const Polytope& a, const Polytope& b)
{
    Real best = -infinity;
    for (const R3 n : axes(a, b))
        if (norm(n) > 0) best = std::max({best, along(a, b, n), along(a, b, Real{-1} * n)});
    return best;
}

/// The largest distance of a corner from the frame's origin.
inline double scale(const Core& a, const Core& b)
{
    Real largest = 0;
    for (const Core* c : {&a, &b})
        for (int k = 0; k < c->count; ++k)
            largest = std::max(largest, norm(real(corner(*c, k))));
    return static_cast<double>(largest);
}

/// The signed distance of two cores.
inline double distance(const Core& a, const Core& b)
{
    const Polytope p = polytope(a), q = polytope(b);
    const Real axis = best_axis(p, q);
    return static_cast<double>(axis < -1e-17L * scale(a, b) ? axis : features(p, q));
}

} // namespace brink::brute

namespace brink {

/// Cores without radius, biased to the nasty: flat, needles, points, parallel, on a grid, sharing corners,
/// all but collinear, touching up to nothing or a little.
class NastyCores {
public:
    explicit NastyCores(std::uint64_t seed) : random(seed) {}
    support::Random random;

    double size()
    {
        const int kind = random.index(6);
        if (kind == 0) return 0;
        if (kind == 1) return random.log_between(1e-7, 1);
        if (kind == 2) return 0.5 * random.index(4);
        return random.between(0, 2);
    }

    V3 point()
    {
        const Vec3 p = random.in_cube(2);
        if (random.index(3) == 0) return {std::floor(p.x()), std::floor(p.y()), std::floor(p.z())};
        return load(p);
    }

    Quat orientation()
    {
        const Quat any = random.rotation();
        const double little = random.log_between(1e-17, 1e-5);
        const int kind = random.index(4);
        if (kind == 0) return {1, 0, 0, 0};
        if (kind == 1) return {1, little * any.x(), little * any.y(), little * any.z()};
        return any;
    }

    Core local(Core::Kind kind)
    {
        const V3 p = point(), q = point(), r = point();
        const double x = size(), y = size(), z = size(), s = random.between(-1, 2);
        const double little = random.log_between(1e-8, 1);
        const int choice = random.index(6);
        if (kind == Core::Kind::segment) return core(Capsule{store(p), store(choice == 0 ? p : q), 0});
        if (kind == Core::Kind::box) return core(Box{{x, y, z}});
        if (kind == Core::Kind::point) return core(Sphere{});
        const V3 on_line = p + s * (q - p);
        const V3 third = choice == 0 ? q : choice == 1 ? on_line : choice == 2 ? on_line + little * r : r;
        return core(Triangle{store(choice == 3 ? p + little * q : p), store(choice == 4 ? 1e6 * q : q),
                             store(third)});
    }

    struct Pair {
        Core a, b;
    };

    Pair pair(Core::Kind kind_a, Core::Kind kind_b)
    {
        const Core a = local(kind_a), b = local(kind_b);
        const Quat qa = orientation(), qb = orientation();
        const V3 at = point();
        const int choice = random.index(8), corner_a = random.index(a.count),
                  corner_b = random.index(b.count);
        const double off = random.log_between(1e-17, 1e-3), sign = random.index(3) - 1;
        const Rotation turn_b = rotation(choice < 3 ? qa : qb);
        const Core placed_a = placed(a, rotation(qa), {}), placed_b = placed(b, turn_b, at);
        if (choice == 0) return {placed_a, placed(b, turn_b, 1e6 * at)};
        if (choice == 1) // share a corner
            return {placed_a,
                    placed(b, turn_b, at + (corner(placed_a, corner_a) - corner(placed_b, corner_b)))};
        if (choice > 4) return {placed_a, placed_b};
        const Separation s = separation(placed_a, placed_b);
        return {placed_a, placed(b, turn_b, at + (sign * off - s.gap) * s.normal)};
    }
};

} // namespace brink
