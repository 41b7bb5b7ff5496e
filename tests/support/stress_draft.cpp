// SPDX-License-Identifier: BSD-3-Clause
#include "stress_draft.h"

#include <algorithm>
#include <vector>

namespace brink::support {

Query assemble(const Draft& d)
{
    Query q{d.a, {}, d.b, {}, {}};
    q.motion_a.start = {d.base + d.path.from, d.turned_a};
    q.motion_a.translation = d.common + d.share * d.path.by;
    q.motion_b.start = {d.base, d.turned_b};
    q.motion_b.translation = d.common - (1 - d.share) * d.path.by;
    q.options.target_gap = d.target_gap;
    return q;
}

Shape scaled(Shape shape, double s)
{
    if (auto* sphere = std::get_if<Sphere>(&shape)) sphere->radius *= s;
    if (auto* box = std::get_if<Box>(&shape)) box->half_extents *= s;
    if (auto* plane = std::get_if<Plane>(&shape)) plane->offset *= s;
    if (auto* solid = std::get_if<HalfSpace>(&shape)) solid->offset *= s;
    if (auto* c = std::get_if<Capsule>(&shape)) *c = Capsule{s * c->a, s * c->b, s * c->radius};
    if (auto* t = std::get_if<Triangle>(&shape)) *t = Triangle{s * t->a, s * t->b, s * t->c};
    if (auto* c = std::get_if<Cylinder>(&shape)) *c = Cylinder{s * c->half_length, s * c->radius};
    if (auto* c = std::get_if<Cone>(&shape)) *c = Cone{s * c->half_length, s * c->radius};
    if (auto* e = std::get_if<Ellipsoid>(&shape)) e->radii *= s;
    if (auto* h = std::get_if<Hull>(&shape)) {
        std::vector<Vec3> points(h->vertices().begin(), h->vertices().end());
        for (Vec3& p : points)
            p *= s;
        *h = Hull::from_points(points);
    }
    return shape;
}

Draft scaled(Draft d, double s)
{
    d.a = scaled(d.a, s);
    d.b = scaled(d.b, s);
    d.path = {s * d.path.from, s * d.path.by};
    d.base *= s;
    d.common *= s;
    d.target_gap *= s;
    return d;
}

Vec3 rotated(const Quat& q, const Vec3& v) { return rounded(rotation_matrix(q) * real3(v)); }

Draft draft(Random& random, const Pair& pair, ShapeStyle style, double distance)
{
    const Shape a = draw_shape(random, pair.first, style);
    const Shape b = draw_shape(random, pair.second, style);
    Quat turned_b = draw_orientation(random);
    Quat turned_a = draw_orientation(random);
    const Vec3 from = distance * random.unit();
    const Vec3 aim = random.in_cube(1);
    const double arrival = random.between(0.1, 1.2);
    Draft d{a, b, turned_a, turned_b, Path{from, (aim - from) / arrival}};
    if (unbounded(b)) d.path = above_ground(random, d.path, b, turned_b);
    d.share = random.chance(0.4) ? 1 : random.between(0, 1);
    if (random.chance(0.3)) d.common = random.in_cube(2);
    if (random.chance(0.5)) d.base = random.in_cube(1);
    if (random.chance(0.1)) d.target_gap = random.log_between(1e-6, 0.5);
    return d;
}

Draft plain(Random& random, const Pair& pair)
{
    const double distance = random.between(2.5, 8);
    return draft(random, pair, ShapeStyle::any, distance);
}

Query brought_near(const Query& q, double gap, double times)
{
    const GapOverTime motion(q);
    const Gap start = motion.at(0);
    const Vec3 by = q.motion_a.translation - q.motion_b.translation;
    const double closing = std::max(0.0, rounded(start.normal).dot(by));
    return tuned(q, start.gap, gap + times * closing);
}

Vec3 core_point(Random& random, const Shape& shape, const Quat& orientation)
{
    const double u = random.between(0, 1);
    const double v = random.between(0, 1 - u);
    const Vec3 inside = random.in_cube(1);
    Vec3 point(0, 0, 0);
    if (const auto* box = std::get_if<Box>(&shape)) point = inside.cwiseProduct(box->half_extents);
    if (const auto* capsule = std::get_if<Capsule>(&shape))
        point = capsule->a + u * (capsule->b - capsule->a);
    if (const auto* t = std::get_if<Triangle>(&shape)) point = t->a + u * (t->b - t->a) + v * (t->c - t->a);
    return rotated(orientation, point);
}

} // namespace brink::support
