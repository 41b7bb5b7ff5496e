// SPDX-License-Identifier: BSD-3-Clause
#include "core.h"
#include "exact.h"
#include "support.h"
#include "tolerance.h"
#include "validity.h"

#include <bit>
#include <cstdint>

namespace brink {

namespace {

constexpr double largest = std::numeric_limits<double>::max();

/// The next double towards +infinity. x finite.
double next_up(double x)
{
    if (x == 0) return std::numeric_limits<double>::denorm_min();
    const auto bits = std::bit_cast<std::int64_t>(x);
    return std::bit_cast<double>(x > 0 ? bits + 1 : bits - 1);
}
double next_down(double x) { return -next_up(-x); }

/// a + b rounded upwards; likewise downwards. (Where it overflows the largest double lies below the sum.)
double sum_up(double a, double b)
{
    const Pair sum = two_sum(a, b);
    if (sum.hi > largest || !(sum.hi >= -largest)) return sum.hi > 0 ? sum.hi : -largest;
    return sum.lo > 0 ? next_up(sum.hi) : sum.hi;
}
double sum_down(double a, double b) { return -sum_up(-a, -b); }

double magnitude(const Quat& q, int k) { return std::fabs(q.coeffs().data()[k]); }

/// Whether a quaternion takes coordinate axes exactly onto coordinate axes: one, two or four of its
/// components are not zero, and those are equal in magnitude.
bool is_axis_permutation(const Quat& q)
{
    int count = 0;
    double size = 0;
    for (int k = 0; k < 4; ++k)
        size = std::fmax(size, magnitude(q, k));
    for (int k = 0; k < 4; ++k) {
        if (magnitude(q, k) != 0 && magnitude(q, k) != size) return false;
        count += magnitude(q, k) != 0;
    }
    return count != 3;
}

V3 whole(V3 v) { return {std::floor(v.x + 0.5), std::floor(v.y + 0.5), std::floor(v.z + 0.5)}; }

/// A rotation and how far a coordinate of a turned vector may be off, per unit of its length.
struct Turn {
    Rotation rotation;
    double error;
};

Turn turn(const Quat& q)
{
    const Rotation r = rotation(q);
    if (is_axis_permutation(q)) return {{whole(r.x), whole(r.y), whole(r.z)}, 0};
    return {r, tolerance::turned};
}

Interval shifted(Interval i, double by) { return {sum_down(i.low, by), sum_up(i.high, by)}; }
Interval widened(Interval i, double by) { return {sum_down(i.low, -by), sum_up(i.high, by)}; }

Aabb box(Interval x, Interval y, Interval z) { return {{x.low, y.low, z.low}, {x.high, y.high, z.high}}; }

/// The largest sum of a point's coordinates without their signs.
double sum_of_coordinates(const Core& local)
{
    const V3 h = local.half_extents;
    if (local.kind == Core::Kind::hull) return local.hull->reach * local.axes.x.x;
    if (local.kind >= Core::Kind::box) return h.x + h.y + h.z;
    double most = 0;
    for (int k = 0; k < local.count; ++k)
        most = std::max(most, sum_of_magnitudes(local.points[k]));
    return most;
}

Aabb bounds(const Core& local, const Turn& t, V3 position)
{
    const double error = t.error * sum_of_coordinates(local);
    const Core turned = placed(local, t.rotation, {});
    const auto along = [&](V3 axis, double offset) {
        return shifted(widened(widened(interval(turned, axis), error), local.radius), offset);
    };
    return box(along({1, 0, 0}, position.x), along({0, 1, 0}, position.y), along({0, 0, 1}, position.z));
}

/// Where a border at right angles to an axis lies along it, from its normal's only coordinate.
Interval level(double normal, double offset, bool solid)
{
    const double exact = offset / normal;
    const Interval at =
        std::fabs(normal) == 1 ? Interval{exact, exact} : Interval{next_down(exact), next_up(exact)};
    if (!solid) return at;
    return normal > 0 ? Interval{-infinity, at.high} : Interval{at.low, infinity};
}

Aabb bounds(V3 local_normal, double offset, bool solid, const Turn& t, V3 position)
{
    const Interval all{-infinity, infinity};
    const V3 n = t.rotation * local_normal;
    if (t.error != 0 || (n.x != 0) + (n.y != 0) + (n.z != 0) != 1) return box(all, all, all);
    if (n.x != 0) return box(shifted(level(n.x, offset, solid), position.x), all, all);
    if (n.y != 0) return box(all, shifted(level(n.y, offset, solid), position.y), all);
    return box(all, all, shifted(level(n.z, offset, solid), position.z));
}

} // namespace

Aabb bounds(const Shape& shape, const Pose& pose)
{
    const Interval all{-infinity, infinity};
    if (!valid(shape, pose)) return box(all, all, all);
    const V3 at = load(pose.position);
    if (const auto* s = std::get_if<Sphere>(&shape)) return bounds(core(*s), {}, at);
    const Turn t = turn(pose.orientation);
    if (const auto* s = std::get_if<Capsule>(&shape)) return bounds(core(*s), t, at);
    if (const auto* s = std::get_if<Box>(&shape)) return bounds(core(*s), t, at);
    if (const auto* s = std::get_if<Triangle>(&shape)) return bounds(core(*s), t, at);
    if (const auto* s = std::get_if<Plane>(&shape)) return bounds(load(s->normal), s->offset, false, t, at);
    if (const auto* s = std::get_if<HalfSpace>(&shape))
        return bounds(load(s->normal), s->offset, true, t, at);
    if (const auto* s = std::get_if<Cylinder>(&shape)) return bounds(core(*s), t, at);
    if (const auto* s = std::get_if<Cone>(&shape)) return bounds(core(*s), t, at);
    if (const auto* s = std::get_if<Ellipsoid>(&shape)) return bounds(core(*s), t, at);
    if (const auto* s = std::get_if<Hull>(&shape)) return bounds(core(*s), t, at);
    return box(all, all, all);
}

} // namespace brink
