// SPDX-License-Identifier: BSD-3-Clause
#include "referee_features.h"

namespace brink::support {
namespace {

using Kind = Feature::Kind;

/// Sine of the angle between a face's edges, squared, below which the face is none.
const Digits no_area{"1e-180"};
/// Sine of the angle between a path and a line, squared, below which they are parallel.
const Digits parallel{"1e-300"};

/// Whether the path has a part that changes the distance.
bool approaches(const Feature& f, const Digits3& by)
{
    const Digits3 change = f.offset(by);
    return dot(change, change) > parallel * f.weight * dot(by, by);
}

} // namespace

Digits3 Feature::offset(const Digits3& from_at) const
{
    if (kind == Kind::corner) return from_at;
    if (kind == Kind::edge) return cross(from_at, u);
    return {dot(from_at, normal), 0, 0};
}

bool Feature::foot_inside(const Digits3& point, const Digits& outside) const
{
    if (kind == Kind::corner) return true;
    const Digits3 w = point - at;
    if (kind == Kind::edge) {
        const Digits along = dot(w, u);
        return along >= -outside * unit_u && along <= weight + outside * unit_u;
    }
    const Digits along_u = dot(cross(w, v), normal); // times weight: the foot's coordinates in u and v
    const Digits along_v = dot(cross(u, w), normal);
    if (along_u < -outside * unit_v || along_v < -outside * unit_u) return false;
    if (kind == Kind::triangle) return along_u + along_v <= weight + outside * unit_w;
    return along_u <= weight + outside * unit_v && along_v <= weight + outside * unit_u;
}

Digits Feature::squared_distance(const Digits3& point) const
{
    const Digits3 x = offset(point - at);
    return dot(x, x) / weight;
}

Feature corner(const Digits3& at)
{
    Feature f;
    f.at = at;
    return f;
}

std::optional<Feature> edge(const Digits3& from, const Digits3& to)
{
    Feature f;
    f.kind = Kind::edge;
    f.at = from;
    const Watch watch;
    f.u = to - from;
    f.weight = dot(f.u, f.u);
    f.exact = watch.exact();
    f.unit_u = sqrt(f.weight);
    if (f.weight == 0) return std::nullopt;
    return f;
}

std::optional<Feature> face(Kind kind, const Digits3& at, const Digits3& u, const Digits3& v)
{
    Feature f;
    f.kind = kind;
    f.at = at;
    f.u = u;
    f.v = v;
    const Watch watch;
    f.normal = cross(u, v);
    f.weight = dot(f.normal, f.normal);
    f.exact = watch.exact();
    if (f.weight <= no_area * dot(u, u) * dot(v, v)) return std::nullopt;
    const Digits length = sqrt(f.weight);
    f.unit_u = length * norm(u);
    f.unit_v = length * norm(v);
    f.unit_w = length * norm(u - v);
    return f;
}

std::optional<FirstTouch> first_touch(const Feature& f, const Ray& ray, const Digits& radius,
                                      const Digits& scale)
{
    // |x + t y|^2 = radius^2 weight: outside at t = 0 and approaching, the smaller root.
    if (!approaches(f, ray.by)) return std::nullopt;
    const Watch watch;
    const Digits3 x = f.offset(ray.from - f.at);
    const Digits3 y = f.offset(ray.by);
    const Digits outside = dot(x, x) - radius * radius * f.weight;
    const Digits towards = -dot(x, y);
    if (outside <= 0 || towards <= 0) return std::nullopt;
    const Digits3 aside = cross(x, y);
    const Digits missed = dot(aside, aside);
    const Digits reached = radius * radius * f.weight * dot(y, y);
    const bool is_face =
        f.kind == Kind::triangle || f.kind == Kind::parallelogram; // a plane is crossed anyhow
    const bool decided = is_face || (watch.exact() && f.exact && ray.exact);
    if (missed > reached) return std::nullopt;
    const Digits root = sqrt(reached - missed);
    const Digits t = outside / (towards + root);
    const bool exact = watch.exact() && f.exact && ray.exact;
    const Digits3 contact = ray.at(t);
    if (!f.foot_inside(contact, border * scale)) return std::nullopt;
    const Digits speed = norm(y);
    const Digits depth = radius - sqrt(missed / f.weight) / speed;
    return FirstTouch{
        .t = t,
        .closing_speed = radius > 0 ? Digits(root / (radius * f.weight)) : Digits(speed / sqrt(f.weight)),
        .exact = exact && f.foot_inside(contact, 0),
        .certain = f.foot_inside(contact, -doubt * scale) && (decided || depth >= doubt * scale)};
}

std::optional<Digits> nearest_time(const Feature& f, const Ray& ray)
{
    if (!approaches(f, ray.by)) return std::nullopt;
    const Digits3 x = f.offset(ray.from - f.at);
    const Digits3 y = f.offset(ray.by);
    return -dot(x, y) / dot(y, y);
}

} // namespace brink::support
