// SPDX-License-Identifier: BSD-3-Clause
#include "path.h"

#include "quick_walk.h"

#include <algorithm>
#include <memory>

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

GapAt gap_at(const Query& q, Aim aim)
{
    if (aim == Aim::exact)
        return [motion = std::make_shared<const GapOverTime>(q)](Real t) { return motion->at(t).gap; };
    struct Sight {
        QuickPair pair;
        Quick3 normal;
    };
    return [sight = std::make_shared<Sight>(Sight{QuickPair(q), {}})](Real t) -> Real {
        const QuickEffort effort{0x1p-54 * sight->pair.scale(), 0, 0};
        const QuickLook look(sight->pair, static_cast<double>(t), sight->normal, effort);
        sight->normal = look.gap.normal;
        return look.gap.upper - sight->pair.radii();
    };
}

Real least_gap(const GapOverTime& motion, double t_max, int steps)
{
    return least_gap([&](Real t) { return motion.at(t).gap; }, t_max, steps);
}

Real least_gap_seen(const GapOverTime& motion, double t_max, Looks looks)
{
    return least_gap_seen([&](Real t) { return motion.at(t).gap; }, t_max, looks);
}

Real least_gap(const GapAt& gap, double t_max, int steps)
{
    constexpr Real golden = 0.618033988749894848L;
    Real from = 0;
    Real to = t_max;
    Real low_t = to - golden * (to - from);
    Real high_t = from + golden * (to - from);
    Real low = gap(low_t);
    Real high = gap(high_t);
    for (int i = 0; i < steps; ++i) {
        if (low <= high) {
            to = high_t;
            high_t = low_t;
            high = low;
            low_t = to - golden * (to - from);
            low = gap(low_t);
        } else {
            from = low_t;
            low_t = high_t;
            low = high;
            high_t = from + golden * (to - from);
            high = gap(high_t);
        }
    }
    return std::min(low, high);
}

Real least_gap_seen(const GapAt& gap, double t_max, Looks looks)
{
    constexpr int closer = 8;
    Real from = 0;
    Real to = t_max;
    Real least = gap(0);
    for (int round = 0; round < looks.rounds; ++round) {
        const int count = round == 0 ? looks.all_over : closer;
        const Real step = (to - from) / count;
        Real best = from;
        for (int i = 0; i <= count; ++i) {
            const Real here = gap(from + i * step);
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
