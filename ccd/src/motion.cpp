// SPDX-License-Identifier: BSD-3-Clause
#include <brink/motion.h>

#include "mover.h"
#include "tolerance.h"
#include "trig.h"
#include "valid_motion.h"
#include "validity.h"

#include <algorithm>

namespace brink {

namespace {

struct Quaternion {
    double w;
    V3 v;
};

Quaternion quaternion(const Quat& q)
{
    const double* c = q.coeffs().data();
    return {c[3], {c[0], c[1], c[2]}};
}

Quaternion product(const Quaternion& p, const Quaternion& q)
{
    return {p.w * q.w - dot(p.v, q.v), p.w * q.v + q.w * p.v + cross(p.v, q.v)};
}

Quaternion unit(const Quaternion& q)
{
    const double length = std::sqrt(q.w * q.w + norm_squared(q.v));
    return {q.w / length, {q.v.x / length, q.v.y / length, q.v.z / length}};
}

Quat quat(const Quaternion& q) { return {q.w, q.v.x, q.v.y, q.v.z}; }

struct Extents {
    V3 min, max;
};

V3 least(V3 a, V3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
V3 most(V3 a, V3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

/// Both ends, grown by what the path between them can stray and by rounding of the order of the coordinates.
Extents around(Extents a, Extents b, double stray)
{
    const V3 min = least(a.min, b.min), max = most(a.max, b.max);
    const auto grow = [stray](double x) { return stray + tolerance::outwards * (std::fabs(x) + stray); };
    return {{min.x - grow(min.x), min.y - grow(min.y), min.z - grow(min.z)},
            {max.x + grow(max.x), max.y + grow(max.y), max.z + grow(max.z)}};
}

constexpr Extents everywhere{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};

/// A turning point leaves the straight line between its two ends by at most |rate|^2 reach t^2 / 8, and the
/// pivot's straight line by at most its reach.
Extents swept(const Mover<Core>& m, Extents start, Extents end, double t_max)
{
    const double rounding =
        tolerance::pose_rounding * (norm(m.arm) + norm(m.translation) + (1 + m.turn.angle) * m.reach);
    const double angle = m.turn.angle * t_max;
    const Extents chord = around(start, end, 0.125 * angle * angle * m.reach + rounding);
    if (angle == 0) return chord;
    const V3 from = m.pivot(0), to = m.pivot(t_max);
    const Extents ball = around({from, from}, {to, to}, m.reach + m.part.radius + rounding);
    return {most(chord.min, ball.min), least(chord.max, ball.max)};
}

Extents swept(const Mover<Border>& m, Extents start, Extents end, double)
{
    if (m.turn.angle > 0) return everywhere;
    return around(start, end, tolerance::pose_rounding * norm(m.translation));
}

Extents extents(const Aabb& box) { return {load(box.min), load(box.max)}; }

} // namespace

Pose Motion::at(double t) const
{
    const V3 from = load(start.position), by = t * load(translation), local = load(pivot);
    const Turn spin = turn(rotation);
    if (spin.angle == 0 || t == 0) return {store(from + by), start.orientation};
    const SinCos half = sin_cos(0.5 * (t * spin.angle));
    const Quaternion turned_now =
        unit(product({half.cos, half.sin * spin.axis}, quaternion(start.orientation)));
    if (local == V3{}) return {store(from + by), quat(turned_now)};
    const V3 arm = brink::rotation(start.orientation) * local;
    return {store(from + (by + (arm - turned(spin, t) * arm))), quat(turned_now)};
}

Motion Motion::still(const Pose& pose) { return {.start = pose}; }

Motion Motion::between(const Pose& from, const Pose& to, const Vec3& pivot)
{
    const Quaternion first = unit(quaternion(from.orientation));
    Quaternion q = unit(product(unit(quaternion(to.orientation)), {first.w, -first.v}));
    if (q.w < 0) q = {-q.w, -q.v};
    const double sine = norm(q.v);
    const double scale = sine > 0 ? 2 * angle_of({sine, q.w}) / sine : 0;
    const V3 local = load(pivot);
    const V3 shift = brink::rotation(to.orientation) * local - brink::rotation(from.orientation) * local;
    const V3 translation = (load(to.position) - load(from.position)) + shift;
    return {from, store(translation), store(scale * q.v), pivot};
}

Aabb swept_bounds(const Shape& shape, const Motion& motion, double t_max)
{
    if (!(t_max >= 0 && t_max <= 1) || !valid(shape, motion))
        return {store(everywhere.min), store(everywhere.max)};
    const Extents start = extents(bounds(shape, motion.start)),
                  end = extents(bounds(shape, motion.at(t_max)));
    const auto sweep = [&](const auto& s) { return swept(mover(s, motion), start, end, t_max); };
    const Extents all = std::visit(sweep, shape);
    return {store(all.min), store(all.max)};
}

} // namespace brink
