// SPDX-License-Identifier: BSD-3-Clause
#include "referee_encounter.h"

#include <algorithm>

namespace brink::support {
namespace {

using Kind = Feature::Kind;

void keep(std::vector<Feature>& features, std::optional<Feature> f)
{
    if (f) features.push_back(std::move(*f));
}

void add_triangle(std::vector<Feature>& out, const Digits3& a, const Digits3& b, const Digits3& c)
{
    for (const Digits3* p : {&a, &b, &c})
        out.push_back(corner(*p));
    keep(out, edge(a, b));
    keep(out, edge(b, c));
    keep(out, edge(c, a));
    keep(out, face(Kind::triangle, a, b - a, c - a));
}

void add_segment(std::vector<Feature>& out, const Digits3& a, const Digits3& b)
{
    out.push_back(corner(a));
    out.push_back(corner(b));
    keep(out, edge(a, b));
}

/// Everything at + s u + t v.
void add_parallelogram(std::vector<Feature>& out, const Digits3& at, const Digits3& u, const Digits3& v)
{
    add_segment(out, at, at + u);
    add_segment(out, at + v, at + v + u);
    keep(out, edge(at, at + v));
    keep(out, edge(at + u, at + u + v));
    keep(out, face(Kind::parallelogram, at, u, v));
}

void add_box(std::vector<Feature>& out, const Digits3& half)
{
    const Digits3 x{half.x, 0, 0};
    const Digits3 y{0, half.y, 0};
    const Digits3 z{0, 0, half.z};
    const Digits two = 2;
    for (const Digits side : {-1, 1}) {
        add_parallelogram(out, side * x - y - z, two * y, two * z);
        keep(out, face(Kind::parallelogram, side * y - z - x, two * z, two * x));
        keep(out, face(Kind::parallelogram, side * z - x - y, two * x, two * y));
        for (const Digits other : {-1, 1})
            keep(out, edge(side * y + other * z - x, side * y + other * z + x));
    }
}

/// The body's core about its position, in the world's axes.
std::vector<Digits3> feet(const Shape& shape, const Quat& orientation)
{
    const auto* capsule = std::get_if<Capsule>(&shape);
    if (capsule == nullptr) return {Digits3{}};
    const Digits33 turn = rotation_in_digits(orientation);
    return {turn * digits3(capsule->a), turn * digits3(capsule->b)};
}

Digits radius(const Shape& shape)
{
    if (const auto* s = std::get_if<Sphere>(&shape)) return s->radius;
    if (const auto* s = std::get_if<Capsule>(&shape)) return s->radius;
    return 0;
}

/// How far the shape reaches from its position: its extents, of design promise 3.
Digits extent(const Shape& shape)
{
    const auto farthest = [](std::initializer_list<Vec3> points) {
        Digits most = 0;
        for (const Vec3& p : points)
            most = std::max(most, norm(digits3(p)));
        return most;
    };
    if (const auto* s = std::get_if<Capsule>(&shape)) return farthest({s->a, s->b});
    if (const auto* s = std::get_if<Box>(&shape)) return farthest({s->half_extents});
    if (const auto* s = std::get_if<Triangle>(&shape)) return farthest({s->a, s->b, s->c});
    if (const auto* s = std::get_if<Plane>(&shape)) return abs(Digits(s->offset)) / norm(digits3(s->normal));
    if (const auto* s = std::get_if<HalfSpace>(&shape))
        return abs(Digits(s->offset)) / norm(digits3(s->normal));
    return 0;
}

Digits scale(const Query& q)
{
    const auto of_body = [](const Shape& shape, const Motion& m) -> Digits {
        return radius(shape) + extent(shape) + norm(digits3(m.pivot));
    };
    return norm(digits3(q.motion_a.start.position) - digits3(q.motion_b.start.position)) +
           norm(digits3(q.motion_a.translation) - digits3(q.motion_b.translation)) +
           of_body(q.a, q.motion_a) + of_body(q.b, q.motion_b) + Digits(q.options.target_gap);
}

/// The core of the shape that stays, about its position and in its own frame.
void add_core(Encounter& e, const Shape& shape)
{
    if (std::holds_alternative<Sphere>(shape)) e.features.push_back(corner({}));
    if (const auto* s = std::get_if<Capsule>(&shape)) add_segment(e.features, digits3(s->a), digits3(s->b));
    if (const auto* s = std::get_if<Triangle>(&shape))
        add_triangle(e.features, digits3(s->a), digits3(s->b), digits3(s->c));
    if (const auto* s = std::get_if<Box>(&shape)) {
        e.half = digits3(s->half_extents);
        add_box(e.features, *e.half);
    }
    if (const auto* s = std::get_if<Plane>(&shape)) e.ground = {digits3(s->normal), s->offset, true, {}};
    if (const auto* s = std::get_if<HalfSpace>(&shape)) e.ground = {digits3(s->normal), s->offset, false, {}};
}

bool inside_box(const Digits3& half, const Digits3& p)
{
    return abs(p.x) <= half.x && abs(p.y) <= half.y && abs(p.z) <= half.z;
}

bool in_contact(const Encounter& e, const Digits3& p)
{
    if (e.half && inside_box(*e.half, p)) return true;
    return std::any_of(e.features.begin(), e.features.end(), [&](const Feature& f) {
        const Digits3 x = f.offset(p - f.at);
        return dot(x, x) <= e.radius * e.radius * f.weight && f.foot_inside(p, 0);
    });
}

Digits core_gap(const Encounter& e, const Digits3& p)
{
    if (e.half && inside_box(*e.half, p))
        return std::max({abs(p.x) - e.half->x, abs(p.y) - e.half->y, abs(p.z) - e.half->z}) - e.radius;
    Digits least = -1;
    for (const Feature& f : e.features) {
        if (!f.foot_inside(p, border * e.scale)) continue;
        const Digits squared = f.squared_distance(p);
        if (least < 0 || squared < least) least = squared;
    }
    return sqrt(least) - e.radius;
}

/// Whether h <= r |normal|, by squares: no root is taken.
bool within(const Digits& h, const Digits& r, const Digits3& normal)
{
    return h <= 0 || h * h <= r * r * dot(normal, normal);
}

bool in_contact(const Ground& ground, const Digits& radius, const Digits3& p)
{
    const auto [low, high] = heights(ground, p);
    return within(low, radius, ground.normal) && (!ground.two_sided || within(-high, radius, ground.normal));
}

} // namespace

Encounter encounter(const Query& q)
{
    Encounter e;
    e.swapped = q.b.index() < q.a.index();
    const Shape& moving = e.swapped ? q.b : q.a;
    const Shape& still = e.swapped ? q.a : q.b;
    const Motion& motion = e.swapped ? q.motion_b : q.motion_a;
    const Motion& base = e.swapped ? q.motion_a : q.motion_b;
    e.scale = scale(q);
    const Watch watch;
    // A sphere's orientation may be anything.
    if (!std::holds_alternative<Sphere>(still)) e.frame = rotation_in_digits(base.start.orientation);
    const auto to_frame = [&](const Digits3& v) { return transposed_times(e.frame, v); };
    e.ray.from = to_frame(digits3(motion.start.position) - digits3(base.start.position));
    e.ray.by = to_frame(digits3(motion.translation) - digits3(base.translation));
    std::vector<Digits3> core = feet(moving, motion.start.orientation);
    std::transform(core.begin(), core.end(), core.begin(), to_frame);
    e.radius = radius(moving) + radius(still) + Digits(q.options.target_gap);
    e.ray.exact = watch.exact();
    if (const auto* s = std::get_if<Capsule>(&still); s != nullptr && core.size() == 2) {
        const Digits3 along = digits3(s->b) - digits3(s->a);
        add_parallelogram(e.features, digits3(s->a) - core[0], along, core[0] - core[1]);
        return e;
    }
    add_core(e, still);
    if (e.ground) e.ground->feet = core;
    return e;
}

Heights heights(const Ground& ground, const Digits3& p)
{
    Heights out;
    for (const Digits3& foot : ground.feet) {
        const Digits h = dot(ground.normal, p + foot) - ground.offset;
        if (&foot == &ground.feet.front()) out = {h, h};
        out.low = std::min(out.low, h);
        out.high = std::max(out.high, h);
    }
    return out;
}

Standing standing(const Encounter& e, const Digits& t)
{
    const auto exact = [](const Feature& f) { return f.exact; };
    Standing out;
    const Watch watch;
    const Digits3 p = e.ray.at(t);
    out.contact = e.ground ? in_contact(*e.ground, e.radius, p) : in_contact(e, p);
    out.exact = watch.exact() && e.ray.exact && std::all_of(e.features.begin(), e.features.end(), exact);
    if (!e.ground) {
        out.gap = core_gap(e, p);
        return out;
    }
    const auto [low, high] = heights(*e.ground, p);
    const Digits nearest = e.ground->two_sided ? std::max(low, Digits(-high)) : low;
    out.gap = nearest / norm(e.ground->normal) - e.radius;
    return out;
}

} // namespace brink::support
