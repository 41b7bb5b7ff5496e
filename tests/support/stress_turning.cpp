// SPDX-License-Identifier: BSD-3-Clause
#include "stress_turning.h"

#include "path.h"
#include "stress_draft.h"

#include <algorithm>

namespace brink::support {
namespace {

constexpr double turn = 6.283185307179586;
constexpr int attempts = 8;

/// How both bodies turn.
struct Spin {
    Vec3 rotation_a{0, 0, 0}, rotation_b{0, 0, 0};
    Vec3 pivot_a{0, 0, 0}, pivot_b{0, 0, 0};
};

/// One of them or both by up to `most`; exactly `most` where all of it is asked for.
enum class Share : unsigned char { any, all };

Spin draw_spin(Random& random, double most, Share share)
{
    const int who = random.index(3);
    const double angle_a = share == Share::all ? most : random.between(0, most);
    const double angle_b = share == Share::all ? most : random.between(0, most);
    const Vec3 axis_a = random.unit();
    const Vec3 axis_b = random.unit();
    Spin spin;
    if (who != 1) spin.rotation_a = angle_a * axis_a;
    if (who != 0) spin.rotation_b = angle_b * axis_b;
    if (random.chance(0.6)) spin.pivot_a = random.in_cube(random.chance(0.8) ? 0.6 : 3);
    if (random.chance(0.6)) spin.pivot_b = random.in_cube(random.chance(0.8) ? 0.6 : 3);
    return spin;
}

/// So that the body's own origin is, at the time `when`, where it would be without turning: what the draft
/// aimed at is aimed at still. Rounding leaves it a little off, which does not matter.
Motion turning(Motion motion, const Vec3& rotation, const Vec3& pivot, double when)
{
    motion.rotation = rotation;
    motion.pivot = pivot;
    const Vec3 straight = motion.start.position + when * motion.translation;
    motion.start.position += straight - motion.at(when).position;
    return motion;
}

/// The draft, with both bodies turning and aimed for some time of the step.
Query assemble(Random& random, const Draft& d, const Spin& spin)
{
    const double when = random.between(0.05, 0.95);
    const Vec3 base = d.base;
    Draft near = d; // what is far from the origin would lose its aim
    near.base = Vec3(0, 0, 0);
    Query q = assemble(near);
    q.motion_a = turning(q.motion_a, spin.rotation_a, spin.pivot_a, when);
    q.motion_b = turning(q.motion_b, spin.rotation_b, spin.pivot_b, when);
    q.motion_a.start.position += base;
    q.motion_b.start.position += base;
    return q;
}

Query plain(Random& random, const Pair& pair, const Spin& spin)
{
    const Draft d = plain(random, pair);
    return assemble(random, d, spin);
}

StressCase draw_angle(Random& random, const Pair& pair)
{
    const bool none = random.chance(0.06);
    const double angle = none ? 0 : random.log_between(1e-12, 100 * turn);
    const Spin spin = draw_spin(random, angle, Share::all);
    return {plain(random, pair, spin), none ? described(TurningStress::angle).first : std::log10(angle)};
}

/// Next to B by about what rocking makes up for, and turning about the corner that is nearest or about the
/// middle. What counts as contact is nearer still.
StressCase draw_rocking(Random& random, const Pair& pair)
{
    const double angle = random.log_between(1e-12, 100 * turn);
    const double apart = std::min(angle, 1.0) * random.log_between(1e-3, 0.3);
    const Vec3 rotation = angle * random.unit();
    const bool on_corner = random.chance(0.5);
    const double down = random.chance(0.5) ? random.between(0, 1.5) : 0; // of `apart`, that A sinks besides
    Draft d = plain(random, pair);
    d.path.by = Vec3(0, 0, 0);
    Query q = assemble(d);
    const GapOverTime motion(q);
    const Gap here = motion.at(0);
    if (here.points_known && here.gap > 0) {
        const double nearer = static_cast<double>(here.gap) - apart - q.options.target_gap;
        const Real3 arm = here.point_a + motion.origin() - real3(q.motion_a.start.position);
        const Real33 axes = rotation_matrix(q.motion_a.start.orientation);
        if (on_corner) q.motion_a.pivot = rounded(transposed_times(axes, arm));
        q.motion_a.start.position += nearer * rounded(here.normal);
        q.motion_a.translation += down * apart * rounded(here.normal);
    }
    q.motion_a.rotation = rotation;
    q.options.tolerance = std::min(1e-9, 1e-3 * apart);
    return {q, std::log10(angle)};
}

/// Mostly turning by as much as moves the body by a few of its sizes.
StressCase draw_pivot(Random& random, const Pair& pair)
{
    const double distance = random.log_between(1, 1e9);
    const double most = random.chance(0.75) ? std::min(turn, 8 / distance) : turn;
    Spin spin = draw_spin(random, most, Share::any);
    const Vec3 to_a = random.unit();
    const Vec3 to_b = random.unit();
    const int who = random.index(3);
    if (who != 1) spin.pivot_a = distance * to_a;
    if (who != 0) spin.pivot_b = distance * to_b;
    return {plain(random, pair, spin), std::log10(distance)};
}

/// About as long as before, and `thin` across.
Shape needle(Random& random, const Shape& shape, double thin)
{
    const double length = random.between(0.5, 1.5);
    const int axis = random.index(3);
    thin *= length;
    Vec3 half(thin, thin, thin);
    half[axis] = length;
    if (std::holds_alternative<Sphere>(shape)) return Sphere{thin};
    if (std::holds_alternative<Capsule>(shape))
        return Capsule{length * Vec3::Unit(axis), -length * Vec3::Unit(axis), thin};
    if (std::holds_alternative<Cylinder>(shape)) return Cylinder{length, thin};
    if (std::holds_alternative<Cone>(shape)) return Cone{length, thin};
    if (std::holds_alternative<Box>(shape)) return Box{half};
    if (std::holds_alternative<Ellipsoid>(shape)) return Ellipsoid{half};
    if (std::holds_alternative<Triangle>(shape))
        return Triangle{-half, half, half.cwiseProduct(Vec3(1, -1, 1))};
    if (!std::holds_alternative<Hull>(shape)) return shape;
    std::vector<Vec3> points;
    const int corners = 4 + random.index(20);
    for (int i = 0; i < corners; ++i)
        points.push_back(random.in_cube(1).cwiseProduct(half));
    return Hull::from_points(points);
}

StressCase draw_needle(Random& random, const Pair& pair)
{
    const double ratio = random.log_between(1, 1e6);
    const Spin spin = draw_spin(random, turn, Share::any);
    const int who = random.index(3);
    Draft d = plain(random, pair);
    if (who != 1) d.a = needle(random, d.a, 1 / ratio);
    if (who != 0) d.b = needle(random, d.b, 1 / ratio);
    return {assemble(random, d, spin), std::log10(ratio)};
}

StressCase draw_origin(Random& random, const Pair& pair)
{
    const double offset = random.log_between(1, 1e12);
    const Spin spin = draw_spin(random, turn, Share::any);
    Draft d = plain(random, pair);
    d.base = offset * random.unit();
    return {assemble(random, d, spin), std::log10(offset)};
}

StressCase draw_far(Random& random, const Pair& pair)
{
    const double distance = random.log_between(1, 1e8);
    const Spin spin = draw_spin(random, turn, Share::any);
    Draft d = draft(random, pair, ShapeStyle::any, 2.5 * distance);
    if (unbounded(d.b)) {
        const Vec3 aim = d.path.from + random.between(0.1, 1.2) * d.path.by;
        d.path.by *= distance;
        d.path.from = aim - random.between(0.1, 2) * d.path.by;
    }
    return {assemble(random, d, spin), std::log10(distance)};
}

StressCase draw_scale(Random& random, const Pair& pair)
{
    const double s = random.log_between(1e-100, 1e100);
    Spin spin = draw_spin(random, turn, Share::any);
    spin.pivot_a *= s;
    spin.pivot_b *= s;
    Query q = assemble(random, scaled(plain(random, pair), s), spin);
    q.options.tolerance *= s;
    return {q, std::log10(s)};
}

/// Of several drafts the first that does not touch of itself, its target gap (or A's radius) chosen so that
/// the closest approach is as wanted.
StressCase draw_grazing(Random& random, const Pair& pair)
{
    const double relative = random.log_between(1e-15, 1e-2);
    const double beyond = random.chance(0.5) ? relative : -relative;
    for (int k = 0;; ++k) {
        const Spin spin = draw_spin(random, turn / 2, Share::any);
        Query q = plain(random, pair, spin);
        q.options.target_gap = 0;
        q.options.tolerance = std::min(1e-9, 0.1 * relative);
        const GapOverTime motion(q);
        const Real least = least_gap_seen(motion, 1, {40, 12});
        if (k < attempts && (least < 0.01L || least > 0.9L * motion.at(0).gap)) continue;
        return {tuned(q, least, beyond), std::log10(relative)};
    }
}

StressCase draw_touching(Random& random, const Pair& pair)
{
    const double relative = random.log_between(1e-16, 1e-3);
    const double sign = random.chance(0.8) ? 1 : -1;
    const bool none = random.chance(0.05);
    const Spin spin = draw_spin(random, turn / 6, Share::any);
    Draft d = plain(random, pair);
    if (random.chance(0.45)) d.path.by = -d.path.by;
    Query q = assemble(random, d, spin);
    q.options.tolerance = std::min(1e-9, 0.1 * relative);
    return {brought_near(q, none ? 0 : sign * relative, 0),
            none ? described(TurningStress::touching).first : std::log10(relative)};
}

StressCase draw_tolerance(Random& random, const Pair& pair)
{
    const double tolerance = random.log_between(1e-15, 1e-1);
    const Spin spin = draw_spin(random, turn, Share::any);
    Query q = plain(random, pair, spin);
    q.options.tolerance = tolerance;
    return {q, std::log10(tolerance)};
}

} // namespace

StressCase stress(const Pair& pair, TurningStress kind, std::uint64_t seed, std::uint64_t index)
{
    const auto which = static_cast<std::uint64_t>(kind);
    Random random(((~seed * 16 + pair.first) * 16 + pair.second) * 16 + which, index);
    switch (kind) {
    case TurningStress::rocking:
        return draw_rocking(random, pair);
    case TurningStress::pivot:
        return draw_pivot(random, pair);
    case TurningStress::needle:
        return draw_needle(random, pair);
    case TurningStress::origin:
        return draw_origin(random, pair);
    case TurningStress::far:
        return draw_far(random, pair);
    case TurningStress::scale:
        return draw_scale(random, pair);
    case TurningStress::grazing:
        return draw_grazing(random, pair);
    case TurningStress::touching:
        return draw_touching(random, pair);
    case TurningStress::tolerance:
        return draw_tolerance(random, pair);
    case TurningStress::angle:
        break;
    }
    return draw_angle(random, pair);
}

} // namespace brink::support
