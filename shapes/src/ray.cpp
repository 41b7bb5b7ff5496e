// SPDX-License-Identifier: BSD-3-Clause
#include <brink/ray.h>

#include "nearest.h"
#include "placed_shape.h"
#include "ray_round.h"
#include "ray_triangle.h"
#include "scaling.h"
#include "support.h"
#include "validity.h"

namespace brink {

namespace {

struct Ray {
    V3 origin, direction;
};

V3 unit(V3 v) { return (1 / norm(v)) * v; }
V3 against(const Ray& ray) { return -unit(ray.direction); }

/// Entry times of a quadratic a t^2 + 2 b t + c <= 0 whose discriminant is known by other means; c > 0
/// outside.
double first_root(double b, double c, double discriminant)
{
    if (!(b < 0) || !(discriminant >= 0)) return infinity;
    return std::max(0.0, c) / (-b + std::sqrt(discriminant));
}

/// |x + t d| = radius. The discriminant in cross products: b^2 - a c would lose (|x| / radius)^2 roundings.
double ray_ball(V3 x, V3 d, double radius)
{
    const double square = radius * radius;
    return first_root(dot(x, d), norm_squared(x) - square,
                      norm_squared(d) * square - norm_squared(cross(x, d)));
}

/// The time at which the ray, from outside the infinite cylinder, enters it between its ends.
double ray_cylinder(V3 x, V3 d, V3 axis, double radius)
{
    const V3 m = cross(x, axis), n = cross(d, axis);
    const double length = norm_squared(axis), across_ray = dot(axis, cross(x, d));
    const double c = norm_squared(m) - radius * radius * length;
    if (!(c > 0)) return infinity;
    const double t =
        first_root(dot(m, n), c, length * (norm_squared(n) * radius * radius - across_ray * across_ray));
    if (!(t < infinity)) return infinity;
    const double along = dot(x + t * d, axis);
    if (!(along >= 0 && along <= length)) return infinity;
    return t;
}

SurfaceEntry enter_capsule(const Ray& ray, const Core& c)
{
    const V3 a = c.points[0], b = c.points[c.count - 1], d = ray.direction;
    const double at_ends =
        std::min(ray_ball(ray.origin - a, d, c.radius), ray_ball(ray.origin - b, d, c.radius));
    const double t = std::min(at_ends, ray_cylinder(ray.origin - a, d, b - a, c.radius));
    if (!(t < infinity)) return {};
    const V3 reached = ray.origin + t * d;
    const V3 to_core = to_segment(a - reached, b - reached);
    const V3 normal = c.radius > 0 ? -unit(to_core) : against(ray);
    return {t, reached + to_core + c.radius * normal, normal};
}

/// A box by its slabs, in its own frame.
struct Slab {
    double enter, leave;
};

Slab slab(double origin, double direction, double half)
{
    if (direction == 0)
        return std::fabs(origin) <= half ? Slab{-infinity, infinity} : Slab{infinity, -infinity};
    const double near = direction > 0 ? -half : half;
    return {(near - origin) / direction, (-near - origin) / direction};
}

SurfaceEntry enter_box(const Ray& ray, const Core& c)
{
    const V3 h = c.half_extents, o = into(c.axes, ray.origin - c.centre), d = into(c.axes, ray.direction);
    const Slab x = slab(o.x, d.x, h.x), y = slab(o.y, d.y, h.y), z = slab(o.z, d.z, h.z);
    const double t = std::max(x.enter, std::max(y.enter, z.enter));
    const double leave = std::min(x.leave, std::min(y.leave, z.leave));
    if (!(t >= 0 && t <= leave && t < infinity)) return {};

    const V3 reached = o + t * d;
    V3 point{std::clamp(reached.x, -h.x, h.x), std::clamp(reached.y, -h.y, h.y),
             std::clamp(reached.z, -h.z, h.z)};
    V3 normal;
    if (t == x.enter) {
        point.x = d.x > 0 ? -h.x : h.x, normal.x = d.x > 0 ? -1 : 1;
    } else if (t == y.enter) {
        point.y = d.y > 0 ? -h.y : h.y, normal.y = d.y > 0 ? -1 : 1;
    } else {
        point.z = d.z > 0 ? -h.z : h.z, normal.z = d.z > 0 ? -1 : 1;
    }
    return {t, c.centre + c.axes * point, c.axes * normal};
}

SurfaceEntry enter_triangle(const Ray& ray, const Core& c)
{
    const V3 p = c.points[0] - ray.origin, q = c.points[1] - ray.origin, r = c.points[2] - ray.origin;
    const RayEntry entry = ray_triangle(ray.direction, p, q, r);
    if (!(entry.t < infinity)) return {};
    const V3 w = entry.weights, point = w.x * c.points[0] + w.y * c.points[1] + w.z * c.points[2];
    const V3 n = face_normal(p, q, r);
    const double rate = dot(n, ray.direction);
    return {entry.t, point, rate == 0 ? against(ray) : (rate > 0 ? -1.0 : 1.0) * unit(n)};
}

Separation separated_from(V3 point, const Core& c)
{
    Core at;
    at.points[0] = point;
    return separation(at, c);
}

/// Any convex core by its supporting planes: each that keeps it apart from the ray's place moves that on,
/// until it is there, or no more nearing it. Newton's method on the distance along the ray, which is convex.
/// (G. van den Bergen, Ray Casting against General Convex Objects, 2004.)
SurfaceEntry enter_by_planes(const Ray& ray, const Core& c)
{
    constexpr int most_rounds = 128; // a ray that grazes halves its distance in each
    SurfaceEntry entry{0, ray.origin, against(ray)};
    const double slack = tolerance::tight * std::max(extent(c), largest_coordinate(ray.origin));
    for (int round = 0; round < most_rounds; ++round) {
        const Separation s = separated_from(entry.point, c);
        const double rate = dot(s.normal, ray.direction), t = entry.t + s.lower / rate;
        const bool there = !(s.lower > slack);
        if (!(rate > 0) && (!there || round == 0)) return {};
        if (there) return {entry.t, s.point_b, entry.normal};
        if (!(t > entry.t)) break;
        entry = {t, ray.origin + t * ray.direction, -s.normal};
    }
    return entry;
}

bool is_flat(const Core& c)
{
    const V3 h = c.half_extents;
    return std::min(h.x, std::min(h.y, h.z)) < tolerance::least_scale;
}

SurfaceEntry enter(const Ray& ray, const Core& c)
{
    if (ray.direction == V3{}) return {};
    if (c.kind == Core::Kind::hull || (c.kind == Core::Kind::ellipsoid && is_flat(c)))
        return enter_by_planes(ray, c);
    if (!is_polytope(c)) return enter_round(ray.origin, ray.direction, c);
    if (c.kind == Core::Kind::box) return enter_box(ray, c);
    if (c.kind == Core::Kind::triangle) return enter_triangle(ray, c);
    return enter_capsule(ray, c);
}

/// From above, where normal . x > offset, or from below.
SurfaceEntry enter(const Ray& ray, const Border& b)
{
    const double height = dot(b.normal, ray.origin) - b.offset, rate = dot(b.normal, ray.direction);
    if (!((height > 0 && rate < 0) || (height < 0 && rate > 0))) return {};
    const double t = -height / rate;
    const V3 reached = ray.origin + t * ray.direction;
    const V3 point = reached - (dot(b.normal, reached) - b.offset) * b.normal;
    return {t, point, height > 0 ? b.normal : -b.normal};
}

/// The ray and the shape in a frame centred at the shape, both scaled to the order of 1.
struct Question {
    Ray ray;
    PlacedShape body;
    int length_exponent, direction_exponent;
};

Question question(V3 origin, V3 direction, const Shape& shape, const Pose& pose)
{
    const V3 at = load(pose.position);
    const PlacedShape b = placed_shape(shape, pose, at);
    const double size = b.bounded ? std::max(extent(b.core), b.core.radius) : std::fabs(b.border.offset);
    const V3 o = scaled(origin, -2) - scaled(at, -2); // a quarter, lest the difference overflow
    const int f = exponent(largest_coordinate(direction));
    const int e = std::max(least_exponent, std::max(exponent(largest_coordinate(o)) + 2, exponent(size)));
    return {{scaled(o, 2 - e), scaled(direction, -f)}, placed_shape(shape, pose, at, -e), e, f};
}

/// The origin's place in the shape: how far inside, and the way out.
Separation standing(const Ray& ray, const PlacedShape& body)
{
    if (body.bounded) return separated_from(ray.origin, body.core);
    Core point;
    point.points[0] = ray.origin;
    return separation(point, body.border);
}

} // namespace

RayHit ray_cast(const Vec3& origin, const Vec3& direction, const Shape& shape, const Pose& pose, double t_max)
{
    const V3 from = load(origin), along = load(direction);
    if (!is_finite(from) || !is_finite(along) || !(t_max >= 0) || !valid(shape, pose)) return {};
    const Question q = question(from, along, shape, pose);
    const Separation s = standing(q.ray, q.body);
    if (s.gap <= 0) return {Status::touching, 0, origin, store(-s.normal)};

    const SurfaceEntry entry = q.body.bounded ? enter(q.ray, q.body.core) : enter(q.ray, q.body.border);
    const double t = std::ldexp(entry.t, q.length_exponent - q.direction_exponent);
    if (!(t <= t_max) || !(t < infinity)) return {Status::separated, t_max, {0, 0, 0}, {0, 0, 0}};
    const V3 point = load(pose.position) + scaled(entry.point, q.length_exponent);
    return {Status::hit, t, store(point), store(entry.normal)};
}

} // namespace brink
