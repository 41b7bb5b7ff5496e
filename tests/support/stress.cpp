// SPDX-License-Identifier: BSD-3-Clause
#include "stress.h"

#include "draw.h"
#include "stress_draft.h"
#include "stress_touching.h"

#include <algorithm>

namespace brink::support {
namespace {

constexpr int attempts = 32;
constexpr int fine_steps = 80; // of golden section: the closest approach within 2e-17 of the step

StressCase draw_scale(Random& random, const Pair& pair)
{
    const double s = random.log_between(1e-150, 1e150);
    return {assemble(scaled(plain(random, pair), s)), std::log10(s)};
}

StressCase draw_origin(Random& random, const Pair& pair)
{
    Draft d = plain(random, pair);
    const double offset = random.log_between(1, 1e12);
    d.base = offset * random.unit();
    return {assemble(d), std::log10(offset)};
}

StressCase draw_far(Random& random, const Pair& pair)
{
    const double distance = random.log_between(1, 1e8);
    Draft d = draft(random, pair, ShapeStyle::any, 2.5 * distance);
    if (unbounded(d.b)) {
        // The same aim, from farther away.
        const Vec3 aim = d.path.from + random.between(0.1, 1.2) * d.path.by;
        d.path.by *= distance;
        d.path.from = aim - random.between(0.1, 2) * d.path.by;
    }
    return {assemble(d), std::log10(distance)};
}

StressCase draw_size_ratio(Random& random, const Pair& pair)
{
    const double small = random.log_between(1e-8, 1);
    Draft d = plain(random, pair);
    const bool larger = random.chance(0.5);
    const double level = larger ? -std::log10(small) : std::log10(small);
    if (unbounded(d.b) && larger) {
        d.path.by *= small;
        d.common *= small;
        return {brought_near(assemble(d), 0, random.between(0.1, 2)), level};
    }
    (larger ? d.b : d.a) = scaled(larger ? d.b : d.a, small);
    const Vec3 aim = core_point(random, d.b, d.turned_b);
    const Vec3 with = core_point(random, d.a, d.turned_a);
    if (!unbounded(d.b) && random.chance(0.4))
        d.path.by =
            (aim - with - d.path.from) / random.between(0.1, 1.2); // chance alone seldom hits thin shapes
    return {assemble(d), level};
}

/// Of many drafts one where A's radius can be chosen so that the closest approach within the step is as
/// wanted.
StressCase draw_grazing(Random& random, const Pair& pair)
{
    const double relative = random.log_between(1e-16, 1e-2);
    const double beyond = random.chance(0.5) ? relative : -relative;
    for (int k = 0;; ++k) {
        const double distance = random.chance(0.7) ? random.between(1.5, 5) : random.log_between(5, 1e4);
        Draft d = draft(random, pair, ShapeStyle::any, distance);
        if (auto* sphere = std::get_if<Sphere>(&d.a)) sphere->radius = 0; // to come
        const Query q = assemble(d);
        const GapOverTime motion(q);
        const Real start = motion.at(0).gap;
        const Real end = motion.at(1).gap;
        const Real least = std::min({least_gap(motion, 1, fine_steps), start, end});
        const Query graze = tuned(q, least, beyond);
        const bool passes = !unbounded(d.b) && least == end; // it would come nearer after the step
        if (k == attempts || (least > beyond + d.target_gap && least < 0.9 * start && !passes))
            return {graze, std::log10(relative)};
    }
}

StressCase draw_equal_velocities(Random& random, const Pair& pair)
{
    const double ratio = random.log_between(1e-12, 1);
    Draft d = plain(random, pair);
    d.common = 4 / ratio * random.unit();
    if (random.chance(0.5)) return {assemble(d), std::log10(ratio)};
    d.common *= ratio;
    d.path.by *= ratio;
    return {brought_near(assemble(d), 0, random.between(0.1, 2)), std::log10(ratio)};
}

StressCase draw_touching(Random& random, const Pair& pair)
{
    const double first = described(Stress::touching).first;
    if (random.chance(0.1)) return {exactly_touching(random, pair), first};
    Draft d = draft(random, pair, ShapeStyle::any, random.between(2.5, 5));
    if (random.chance(0.45)) d.path.by = -d.path.by;
    const double relative = random.log_between(1e-16, 1e-3);
    const double sign = random.chance(0.8) ? 1 : -1;
    const bool none = random.chance(0.05);
    return {brought_near(assemble(d), none ? 0 : sign * relative, 0),
            none ? first + 0.5 : std::log10(relative)};
}

/// One of the directions that a shape of ShapeStyle::aligned has an edge or face along, and one that is
/// perpendicular to that edge or face; in its own frame.
struct Grain {
    Vec3 along{1, 0, 0}, across{0, 0, 1};
};

Vec3 perpendicular(Random& random, const Vec3& axis)
{
    const Vec3 other = random.unit();
    return (other - other.dot(axis) * axis).normalized();
}

Grain draw_grain(Random& random, const Shape& shape)
{
    Grain grain;
    const bool oblique = random.chance(0.5); // along a face but no edge
    if (std::holds_alternative<Capsule>(shape)) grain.across = perpendicular(random, grain.along);
    if (std::holds_alternative<Box>(shape)) {
        const int axis = random.index(3);
        grain = {Vec3::Unit(axis), Vec3::Unit((axis + 1) % 3)};
    }
    if (const auto* plane = std::get_if<Plane>(&shape)) grain.across = plane->normal;
    if (const auto* solid = std::get_if<HalfSpace>(&shape)) grain.across = solid->normal;
    if (std::holds_alternative<Plane>(shape) || std::holds_alternative<HalfSpace>(shape))
        grain.along = Vec3(grain.across.y(), grain.across.z(), grain.across.x());
    if (oblique && !std::holds_alternative<Capsule>(shape)) grain.along = perpendicular(random, grain.across);
    return grain;
}

/// Two spheres have nothing to be parallel but the motion to the line of centres.
Path head_on(Random& random, const Vec3& from, double angle)
{
    const Vec3 line = -from.normalized();
    const Vec3 direction = line + angle * perpendicular(random, line);
    return {from, from.norm() / random.between(0.3, 3) * direction};
}

StressCase draw_parallel(Random& random, const Pair& pair)
{
    const bool exact = random.chance(0.1);
    const double angle = exact ? 0 : random.log_between(1e-14, 1e-1);
    const double level = exact ? described(Stress::parallel).first : std::log10(angle);
    Draft d = draft(random, pair, ShapeStyle::aligned, random.between(2.5, 6));
    if (exact) d.turned_b = Quat(1, 0, 0, 0);
    if (pair.second == 0) {
        const Vec3 from = exact ? Vec3(d.path.from.norm(), 0, 0) : d.path.from;
        d.path = head_on(random, from, angle);
        return {assemble(d), level};
    }
    const bool axes = pair.first == 1 && random.chance(0.5); // A's axis, and not the motion
    const Vec3 turn = angle * random.unit();
    if (pair.first == 1 && random.chance(axes ? 1 : 0.3)) d.turned_a = turned_by(d.turned_b, turn);
    const bool slides = random.chance(0.5); // along a face or edge and slowly into it
    if (!axes) {
        const Grain grain = draw_grain(random, d.b);
        const Vec3 direction = rotated(d.turned_b, grain.along) - angle * rotated(d.turned_b, grain.across);
        const Vec3 inside = core_point(random, d.b, d.turned_b);
        const Vec3 aim = random.chance(0.5) ? inside : random.in_cube(1);
        d.path.by = (slides ? random.between(0.1, 2) : random.between(2, 8)) * direction;
        d.path.from = aim - random.between(0.1, 1.2) * d.path.by;
        if (slides || unbounded(d.b)) d.path.from = aim + 3 * rotated(d.turned_b, grain.across);
    }
    if (axes || (!slides && !unbounded(d.b))) return {assemble(d), level};
    return {brought_near(assemble(d), 0, random.between(0.1, 2)), level};
}

/// A query that certainly has contact, and then a t_max that is that moment but for the last bits; or the
/// same motion in another time, so that the moment is 1.
StressCase draw_t_max(Random& random, const Pair& pair)
{
    Query q = assemble(plain(random, pair));
    Reference known = reference(q, GapOverTime(q));
    for (int k = 0; k < attempts && !(known.contact && known.t > 0); ++k) {
        q = assemble(plain(random, pair));
        known = reference(q, GapOverTime(q));
    }
    auto t = static_cast<double>(known.t);
    if (random.chance(0.3)) {
        q.motion_a.translation *= t;
        q.motion_b.translation *= t;
        return {q, 0};
    }
    if (random.chance(0.6)) {
        const double shorter = random.log_between(1e-4, 1);
        q.motion_a.translation /= shorter;
        q.motion_b.translation /= shorter;
        t = static_cast<double>(reference(q, GapOverTime(q)).t);
    }
    const int ulps = random.index(5) - 2;
    for (int k = 0; k < std::abs(ulps); ++k)
        t = std::nextafter(t, ulps < 0 ? 0.0 : 2.0);
    q.options.t_max = std::min(t, 1.0);
    return {q, std::log10(q.options.t_max)};
}

} // namespace

std::optional<Stress> stress_named(std::string_view name)
{
    for (const StressClass& c : stress_classes)
        if (c.name == name) return c.stress;
    return std::nullopt;
}

StressCase stress(const Pair& pair, Stress kind, std::uint64_t seed, std::uint64_t index)
{
    Random random((seed * 64 + pair.first * 8 + pair.second) * 16 + static_cast<std::uint64_t>(kind), index);
    switch (kind) {
    case Stress::scale:
        return draw_scale(random, pair);
    case Stress::origin:
        return draw_origin(random, pair);
    case Stress::far:
        return draw_far(random, pair);
    case Stress::size_ratio:
        return draw_size_ratio(random, pair);
    case Stress::grazing:
        return draw_grazing(random, pair);
    case Stress::parallel:
        return draw_parallel(random, pair);
    case Stress::equal_velocities:
        return draw_equal_velocities(random, pair);
    case Stress::touching:
        return draw_touching(random, pair);
    case Stress::t_max:
        return draw_t_max(random, pair);
    case Stress::random:
        break;
    }
    return {assemble(plain(random, pair)), 0.5};
}

} // namespace brink::support
