// SPDX-License-Identifier: BSD-3-Clause
#include "path.h"

#include <algorithm>

namespace brink::support {
namespace {

/// Not Eigen's, whose order of summation may follow the machine.
double dot(const Vec3& a, const Vec3& b) { return a.x() * b.x() + a.y() * b.y() + a.z() * b.z(); }

} // namespace

bool unbounded(const Shape& shape)
{
    return std::holds_alternative<Plane>(shape) || std::holds_alternative<HalfSpace>(shape);
}

Path above_ground(Random& random, Path path, const Shape& ground, const Quat& orientation)
{
    const Placed placed = place(ground, RealPose{{}, rotation_matrix(orientation)});
    const Vec3 normal = rounded(placed.normal);
    const double height = dot(normal, path.from) - static_cast<double>(placed.offset);
    const bool below = std::holds_alternative<Plane>(ground) && random.chance(0.3);
    const double wanted = random.between(0.3, 4) * (below ? -1 : 1);
    if (random.chance(0.9)) path.from += (wanted - height) * normal;
    const double along = dot(normal, path.by);
    const double speed = random.between(0.2, 1.8) * wanted;
    if (random.chance(0.7)) path.by -= (along + speed) * normal;
    return path;
}

Real least_gap(const GapOverTime& motion, double t_max, int steps)
{
    constexpr Real golden = 0.618033988749894848L;
    Real from = 0;
    Real to = t_max;
    Real low_t = to - golden * (to - from);
    Real high_t = from + golden * (to - from);
    Real low = motion.at(low_t).gap;
    Real high = motion.at(high_t).gap;
    for (int i = 0; i < steps; ++i) {
        if (low <= high) {
            to = high_t;
            high_t = low_t;
            high = low;
            low_t = to - golden * (to - from);
            low = motion.at(low_t).gap;
        } else {
            from = low_t;
            low_t = high_t;
            low = high;
            high_t = from + golden * (to - from);
            high = motion.at(high_t).gap;
        }
    }
    return std::min(low, high);
}

Real least_gap_seen(const GapOverTime& motion, double t_max, Looks looks)
{
    constexpr int closer = 8;
    Real from = 0;
    Real to = t_max;
    Real least = motion.at(0).gap;
    for (int round = 0; round < looks.rounds; ++round) {
        const int count = round == 0 ? looks.all_over : closer;
        const Real step = (to - from) / count;
        Real best = from;
        for (int i = 0; i <= count; ++i) {
            const Real here = motion.at(from + i * step).gap;
            if (here > least) continue;
            least = here;
            best = from + i * step;
        }
        from = std::max<Real>(best - step, 0);
        to = std::min<Real>(best + step, t_max);
    }
    return least;
}

Query tuned(Query q, Real measured, double beyond)
{
    const Real excess = measured - static_cast<Real>(q.options.target_gap) - static_cast<Real>(beyond);
    const auto grow = [&](double radius) { return static_cast<double>(radius + excess); };
    if (auto* s = std::get_if<Sphere>(&q.a); s != nullptr && grow(s->radius) >= 0) {
        s->radius = grow(s->radius);
        return q;
    }
    if (auto* s = std::get_if<Capsule>(&q.a); s != nullptr && grow(s->radius) >= 0) {
        s->radius = grow(s->radius);
        return q;
    }
    const auto target = static_cast<double>(q.options.target_gap + excess);
    if (target >= 0) q.options.target_gap = target;
    return q;
}

} // namespace brink::support
