// SPDX-License-Identifier: BSD-3-Clause
#include "path.h"
#include "query.h"

#include <algorithm>

namespace brink::support {
namespace {

constexpr double turn = 6.283185307179586;

/// Long and thin, along any axis.
std::optional<Shape> needle(Random& random, const Shape& shape)
{
    const double thin = random.log_between(1e-9, 1e-2);
    const double length = random.between(0.3, 2);
    const int axis = random.index(3);
    if (std::holds_alternative<Cylinder>(shape)) return Cylinder{length, thin};
    if (std::holds_alternative<Cone>(shape)) return Cone{length, thin};
    Vec3 half(thin, thin, thin);
    half[axis] = length;
    if (std::holds_alternative<Box>(shape)) return Box{half};
    if (std::holds_alternative<Ellipsoid>(shape)) return Ellipsoid{half};
    if (std::holds_alternative<Triangle>(shape)) return Triangle{-half, half, thin * Vec3(1, -1, 1)};
    return std::nullopt;
}

Vec3 draw_turns(Random& random)
{
    const Vec3 axis = random.unit();
    const int kind = random.index(16);
    if (kind == 0) return random.between(10, 100) * turn * axis;
    if (kind < 6) return random.between(1, 10) * turn * axis;
    if (kind < 11) return random.between(60, 300) / 360 * turn * axis;
    return random.between(0, 60) / 360 * turn * axis;
}

Motion draw_turning(Random& random, Motion motion)
{
    motion.rotation = draw_turns(random);
    if (random.chance(0.6)) motion.pivot = random.in_cube(random.chance(0.8) ? 0.6 : 3);
    return motion;
}

/// Body A put next to body B, turning about the corner that is nearest.
Query rocking(Random& random, Query q)
{
    const double apart = random.log_between(1e-9, 1e-2);
    const double drift = random.chance(0.5) ? 0 : random.log_between(1e-9, 1e-1);
    const Vec3 by = drift * random.unit();
    const Vec3 rotation = draw_turns(random);
    const GapOverTime motion(q);
    const Gap here = motion.at(0);
    if (!here.points_known || here.gap <= 0) return q;
    const Real3 arm = here.point_a + motion.origin() - real3(q.motion_a.start.position);
    const Real33 axes = rotation_matrix(q.motion_a.start.orientation);
    const double nearer = static_cast<double>(here.gap) - apart - q.options.target_gap;
    q.motion_a.pivot = rounded(transposed_times(axes, arm));
    q.motion_a.start.position += nearer * rounded(here.normal);
    q.motion_a.translation = q.motion_b.translation + by;
    q.motion_a.rotation = rotation;
    q.motion_b.rotation = Vec3(0, 0, 0);
    return q;
}

Query grazing(Random& random, const Query& q, Aim aim)
{
    const double size = random.log_between(1e-15, 1e-3);
    const int side = random.index(3);
    return tuned(q, least_gap_seen(gap_at(q, aim), q.options.t_max, {96, 8}),
                 side == 0   ? -size
                 : side == 1 ? size
                             : 0);
}

} // namespace

Query campaign_query(const Pair& pair, std::uint64_t seed, std::uint64_t index, Aim aim)
{
    Random random(~seed * 128 + pair.first * 10 + pair.second, index);
    const bool rotates = random.chance(0.8);
    Query q = query(pair, rotates ? Family::rotation : Family::translation, seed, index, aim);
    if (pair.unbounded()) return q;
    constexpr std::array<double, 5> tolerances{1e-12, 1e-9, 1e-6, 1e-4, 0};
    q.options.tolerance = tolerances[static_cast<std::size_t>(random.index(5))];
    const std::optional<Shape> thin_a = needle(random, q.a);
    const std::optional<Shape> thin_b = needle(random, q.b);
    const int thin = random.index(16);
    if (thin < 2 && thin_a) q.a = *thin_a;
    if (thin > 0 && thin < 3 && thin_b) q.b = *thin_b;
    const int who = random.index(9);
    if (rotates && who < 4 && who != 1) q.motion_a = draw_turning(random, q.motion_a);
    if (rotates && who < 4 && who != 2) q.motion_b = draw_turning(random, q.motion_b);
    const int scheme = random.index(8);
    if (rotates && scheme == 0) q = rocking(random, q);
    if (scheme == 1) q = grazing(random, q, aim);
    return q;
}

} // namespace brink::support
