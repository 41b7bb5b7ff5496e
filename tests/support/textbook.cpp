// SPDX-License-Identifier: BSD-3-Clause
#include "textbook.h"

#include <algorithm>
#include <cmath>

namespace brink::support {
namespace {

/// One body's core, in the world, as seen from its own position.
struct Core {
    std::vector<Vec3> points;
    double radius = 0;
};

/// A point that moves against corners, edges and flat convex faces, all grown by `radius`.
struct Features {
    std::vector<Vec3> corners;
    std::vector<std::array<int, 2>> edges;
    std::vector<std::vector<int>> faces; // corners in order
    bool solid = false;                  // a closed body about the faces
};

struct Ray {
    Vec3 from, by;
    Vec3 at(double t) const { return from + t * by; }
};

Vec3 world(const Motion& m, const Vec3& local) { return m.start.orientation.normalized() * local; }

/// Empty for a root before the start or none.
std::optional<double> first_root(double a, double b, double c, Root root)
{
    const double discriminant = b * b - a * c;
    if (!(b < 0) || !(discriminant >= 0)) return std::nullopt;
    const double s = std::sqrt(discriminant);
    const double t = root == Root::textbook ? (-b - s) / a : c / (-b + s);
    if (!(t >= 0)) return std::nullopt;
    return t;
}

std::optional<double> meets_ball(const Ray& ray, const Vec3& centre, double radius, Root root)
{
    const Vec3 x = ray.from - centre;
    return first_root(ray.by.dot(ray.by), x.dot(ray.by), x.dot(x) - radius * radius, root);
}

std::optional<double> meets_cylinder(const Ray& ray, const Vec3& end, const Vec3& other, double radius,
                                     Root root)
{
    const Vec3 edge = other - end;
    const double length2 = edge.dot(edge);
    if (!(length2 > 0)) return std::nullopt;
    const auto across = [&](const Vec3& v) { return Vec3(v - v.dot(edge) / length2 * edge); };
    const Vec3 x = across(ray.from - end);
    const Vec3 by = across(ray.by);
    const auto t = first_root(by.dot(by), x.dot(by), x.dot(x) - radius * radius, root);
    if (!t) return t;
    const double foot = (ray.at(*t) - end).dot(edge) / length2;
    return foot >= 0 && foot <= 1 ? t : std::nullopt;
}

Vec3 normal_of(const Features& f, const std::vector<int>& face)
{
    const auto corner = [&](std::size_t i) { return f.corners[static_cast<std::size_t>(face[i])]; };
    return (corner(1) - corner(0)).cross(corner(2) - corner(1)).normalized();
}

bool has_area(const Vec3& normal) { return normal.squaredNorm() > 0.5; }

/// Whether a point, moved along the normal into the face's plane, lies in the face.
bool over(const Features& f, const std::vector<int>& face, const Vec3& normal, const Vec3& point)
{
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Vec3 a = f.corners[static_cast<std::size_t>(face[i])];
        const Vec3 b = f.corners[static_cast<std::size_t>(face[(i + 1) % face.size()])];
        if ((b - a).cross(point - a).dot(normal) < 0) return false;
    }
    return true;
}

std::optional<double> meets_face(const Ray& ray, const Features& f, const std::vector<int>& face,
                                 double radius)
{
    const Vec3 normal = normal_of(f, face);
    if (!has_area(normal)) return std::nullopt;
    const double height = normal.dot(ray.from - f.corners[static_cast<std::size_t>(face[0])]);
    const double rate = normal.dot(ray.by) * (height < 0 ? -1 : 1);
    const double t = (std::abs(height) - radius) / -rate;
    if (!(rate < 0) || !(t >= 0)) return std::nullopt;
    return over(f, face, normal, ray.at(t)) ? std::optional(t) : std::nullopt;
}

double distance_to_edge(const Vec3& p, const Vec3& a, const Vec3& b)
{
    const Vec3 edge = b - a;
    const double length2 = edge.dot(edge);
    const double s = length2 > 0 ? std::clamp((p - a).dot(edge) / length2, 0.0, 1.0) : 0;
    return (p - a - s * edge).norm();
}

/// Distance of a point from the features; 0 inside a solid.
double distance_to(const Features& f, const Vec3& p)
{
    double least = infinity;
    bool inside = f.solid;
    for (const Vec3& corner : f.corners)
        least = std::min(least, (p - corner).norm());
    for (const auto& [a, b] : f.edges)
        least = std::min(least, distance_to_edge(p, f.corners[static_cast<std::size_t>(a)],
                                                 f.corners[static_cast<std::size_t>(b)]));
    for (const auto& face : f.faces) {
        const Vec3 normal = normal_of(f, face);
        inside = inside && has_area(normal);
        if (!has_area(normal)) continue;
        const double height = normal.dot(p - f.corners[static_cast<std::size_t>(face[0])]);
        inside = inside && height <= 0;
        if (over(f, face, normal, p)) least = std::min(least, std::abs(height));
    }
    return inside ? 0 : least;
}

Core core(const Shape& shape, const Motion& m)
{
    if (const auto* s = std::get_if<Sphere>(&shape)) return {{world(m, Vec3(0, 0, 0))}, s->radius};
    if (const auto* c = std::get_if<Capsule>(&shape)) return {{world(m, c->a), world(m, c->b)}, c->radius};
    if (const auto* t = std::get_if<Triangle>(&shape))
        return {{world(m, t->a), world(m, t->b), world(m, t->c)}};
    Core core;
    if (const auto* box = std::get_if<Box>(&shape)) {
        for (int k = 0; k < 8; ++k) {
            const Vec3 signs((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1);
            core.points.push_back(world(m, box->half_extents.cwiseProduct(signs)));
        }
    }
    return core;
}

/// B's core less A's: the features that A's first point, or a sphere's centre, can meet.
Features features(const Core& a, const Core& b)
{
    if (b.points.size() == 8)
        return {
            b.points,
            {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}},
            {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}},
            true};
    if (b.points.size() == 3) return {b.points, {{0, 1}, {1, 2}, {2, 0}}, {{0, 1, 2}}};
    if (a.points.size() == 2) { // the parallelogram of all differences
        const Vec3 along = a.points[1] - a.points[0];
        const Vec3 p = b.points[0];
        const Vec3 q = b.points[1];
        return {{p, q, q - along, p - along}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, {{0, 1, 2, 3}}};
    }
    if (b.points.size() == 2) return {b.points, {{0, 1}}, {}};
    return {b.points, {}, {}};
}

std::optional<double> meets_features(const Ray& ray, const Features& f, double radius, Root root)
{
    if (distance_to(f, ray.from) <= radius) return 0;
    std::optional<double> first;
    const auto keep = [&](std::optional<double> t) {
        if (t && (!first || *t < *first)) first = t;
    };
    for (const Vec3& corner : f.corners)
        keep(meets_ball(ray, corner, radius, root));
    for (const auto& [a, b] : f.edges)
        keep(meets_cylinder(ray, f.corners[static_cast<std::size_t>(a)],
                            f.corners[static_cast<std::size_t>(b)], radius, root));
    for (const auto& face : f.faces)
        keep(meets_face(ray, f, face, radius));
    return first;
}

/// Every point of the core against ground: the normal and offset as seen from B's position.
std::optional<double> meets_ground(const Ray& ray, const Core& a, double target_gap, const Vec3& normal,
                                   double offset, bool solid)
{
    const double length = normal.norm();
    double low = infinity;
    double high = -infinity;
    for (const Vec3& p : a.points) {
        const double height = (normal.dot(ray.from + p) - offset) / length;
        low = std::min(low, height);
        high = std::max(high, height);
    }
    double rate = normal.dot(ray.by) / length;
    const bool below = !solid && high < 0;
    const double reach = a.radius + target_gap;
    const double gap = (below ? -high : low) - reach;
    if (below) rate = -rate;
    if (gap <= 0) return 0;
    if (!(rate < 0)) return std::nullopt;
    return gap / -rate;
}

std::optional<double> first_contact(const Query& q, Root root)
{
    const Core a = core(q.a, q.motion_a);
    const Ray ray{q.motion_a.start.position - q.motion_b.start.position,
                  q.motion_a.translation - q.motion_b.translation};
    if (const auto* p = std::get_if<Plane>(&q.b))
        return meets_ground(ray, a, q.options.target_gap, world(q.motion_b, p->normal), p->offset, false);
    if (const auto* h = std::get_if<HalfSpace>(&q.b))
        return meets_ground(ray, a, q.options.target_gap, world(q.motion_b, h->normal), h->offset, true);
    const Core b = core(q.b, q.motion_b);
    const Ray point{ray.from + a.points[0], ray.by};
    return meets_features(point, features(a, b), a.radius + b.radius + q.options.target_gap, root);
}

} // namespace

std::optional<double> textbook_toi(const Query& q, Root root)
{
    const std::optional<double> t = first_contact(q, root);
    return t && *t <= q.options.t_max ? t : std::nullopt;
}

} // namespace brink::support
