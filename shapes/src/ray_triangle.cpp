// SPDX-License-Identifier: BSD-3-Clause
#include "ray_triangle.h"

#include "nearest.h"

namespace brink {

namespace {

RayEntry earlier(const RayEntry& a, const RayEntry& b) { return b.t < a.t ? b : a; }

/// A single point; weights as of the first corner.
RayEntry ray_point(V3 d, V3 p)
{
    if (!(cross(d, p) == V3{}) || dot(d, p) < 0) return {};
    if (p == V3{}) return {0, {1, 0, 0}};
    return d == V3{} ? RayEntry{} : RayEntry{dot(d, p) / norm_squared(d), {1, 0, 0}};
}

/// The segment from p to q; weights as of the first two corners.
RayEntry ray_segment(V3 d, V3 p, V3 q)
{
    const V3 e = q - p, m = cross(d, e);
    if (m == V3{}) {
        // In one line, if at all. From within it is hit at once.
        const double along = -dot(p, e), length = norm_squared(e);
        if (along > 0 && along < length && cross(p, e) == V3{})
            return {0, {1 - along / length, along / length, 0}};
        RayEntry at_q = ray_point(d, q);
        at_q.weights = {0, 1, 0};
        return earlier(ray_point(d, p), at_q);
    }
    const double square = norm_squared(m);
    const double t = dot(cross(p, e), m) / square, s = dot(cross(p, d), m) / square;
    if (dot(p, m) != 0 || !(t >= 0 && s >= 0 && s <= 1)) return {};
    return {t, {1 - s, s, 0}};
}

/// How far the origin lies inside each edge of a triangle with normal n (the edges qr, rp, pq), not
/// normalised.
V3 inside_edges(V3 n, V3 p, V3 q, V3 r)
{
    return {dot(n, cross(q, r - q)), dot(n, cross(r, p - r)), dot(n, cross(p, q - p))};
}

bool none_negative(V3 v) { return v.x >= 0 && v.y >= 0 && v.z >= 0; }

V3 normalised(V3 weights)
{
    const double sum = weights.x + weights.y + weights.z;
    return {weights.x / sum, weights.y / sum, weights.z / sum};
}

/// A ray in the plane of the triangle, or any ray where the triangle is a segment or a point.
RayEntry ray_edges(V3 d, V3 p, V3 q, V3 r)
{
    const RayEntry pq = ray_segment(d, p, q);
    RayEntry qr = ray_segment(d, q, r), rp = ray_segment(d, r, p);
    qr.weights = {0, qr.weights.x, qr.weights.y};
    rp.weights = {rp.weights.y, 0, rp.weights.x};
    return earlier(pq, earlier(qr, rp));
}

} // namespace

RayEntry ray_triangle(V3 direction, V3 p, V3 q, V3 r)
{
    const V3 normal = face_normal(p, q, r);
    const double rate = dot(normal, direction), height = dot(normal, p);
    if (rate == 0) {
        const V3 inside = inside_edges(normal, p, q, r);
        const bool starts_inside = height == 0 && !(normal == V3{}) && none_negative(inside);
        if (starts_inside) return {0, normalised(inside)};
        return height == 0 ? ray_edges(direction, p, q, r) : RayEntry{};
    }
    const V3 ahead = rate > 0 ? direction : -direction;
    const V3 weights = inside_edges(ahead, p, q, r);
    const double t = height / rate;
    if (!(t >= 0) || !none_negative(weights)) return {};
    return {t, normalised(weights)};
}

} // namespace brink
