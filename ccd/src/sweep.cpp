// SPDX-License-Identifier: BSD-3-Clause
#include "sweep.h"

#include "core.h"
#include "mover.h"
#include "support.h"
#include "tolerance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brink {

namespace {

constexpr double largest_float = std::numeric_limits<float>::max();

struct Span3 {
    V3 min, max;
};

struct ToCore {
    Core operator()(const Plane&) const { return {}; }
    Core operator()(const HalfSpace&) const { return {}; }
    template <class Bounded> Core operator()(const Bounded& shape) const { return core(shape); }
};

Core core_of(const Shape& shape)
{
    if (const auto* s = std::get_if<Sphere>(&shape)) return core(*s);
    if (const auto* s = std::get_if<Box>(&shape)) return core(*s);
    return std::visit(ToCore{}, shape);
}

/// The extent of a core turned about the body's origin, its radius included.
Span3 extent_of(const Core& local, const Quat& orientation)
{
    Span3 s{};
    if (local.kind != Core::Kind::point || !(local.points[0] == V3{})) {
        const Core turned = placed(local, rotation(orientation), {});
        const Interval x = interval(turned, {1, 0, 0}), y = interval(turned, {0, 1, 0}),
                       z = interval(turned, {0, 0, 1});
        s = {{x.low, y.low, z.low}, {x.high, y.high, z.high}};
    }
    const V3 round{local.radius, local.radius, local.radius};
    return {s.min - round, s.max + round};
}

V3 arm_of(const Motion& m)
{
    const V3 pivot = load(m.pivot);
    return pivot == V3{} ? V3{} : rotation(m.start.orientation) * pivot;
}

/// The radius of the ball about the pivot that holds the body.
double reach_about(const Core& local, V3 pivot)
{
    if (local.kind == Core::Kind::point) return norm(local.points[0] - pivot) + local.radius;
    return (pivot == V3{} ? reach(local) : reach(placed(local, {}, -pivot))) + local.radius;
}

/// A coordinate in float and by how much it is off.
struct Rounded {
    float value;
    double off;
};
Rounded rounded(double x)
{
    const auto value = static_cast<float>(std::clamp(x, -largest_float, largest_float));
    return {value, std::fabs(x - static_cast<double>(value))};
}

/// Coordinates in float; returns by how much the point is off.
double round_to(float (&to)[3], V3 v)
{
    const Rounded x = rounded(v.x), y = rounded(v.y), z = rounded(v.z);
    to[0] = x.value, to[1] = y.value, to[2] = z.value;
    return x.off + y.off + z.off;
}

Box3f outwards(V3 min, V3 max)
{
    return {{round_down(min.x), round_down(min.y), round_down(min.z)},
            {round_up(max.x), round_up(max.y), round_up(max.z)}};
}

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr Sweep everywhere{{{-inf, -inf, -inf}, {inf, inf, inf}}, {0, 0, 0}, {0, 0, 0}, inf};

} // namespace

float round_down(double x) { return -round_up(-x); }

float round_up(double x)
{
    if (x > largest_float) return std::numeric_limits<float>::infinity();
    const auto f = static_cast<float>(std::max(x, -largest_float));
    return f + (std::fabs(f) * tolerance::float_outwards + std::numeric_limits<float>::denorm_min());
}

Sweep sweep(const Body& body, V3 origin)
{
    const Motion& m = body.motion;
    const Core local = core_of(body.shape);
    const V3 by = load(m.translation), turn = load(m.rotation), arm = arm_of(m);
    const V3 at = load(m.start.position) - origin, pivot = at + arm;
    const double angle = turn == V3{} ? 0 : norm(turn), reach = reach_about(local, load(m.pivot));
    const double room = tolerance::sweep_slack * (sum_of_magnitudes(at) + sum_of_magnitudes(by) +
                                                  (1 + angle) * (reach + 2 * sum_of_magnitudes(arm)));
    const double ball = reach + room;
    if (!(sum_of_magnitudes(at) + sum_of_magnitudes(by) + ball <= tolerance::largest_culled))
        return everywhere;

    Sweep s;
    const double off = round_to(s.from, pivot) + round_to(s.by, by);
    s.radius = round_up(ball + tolerance::float_sums * off);

    // A point of the body leaves the pivot's straight path, taken along from the start, by the chord of the
    // turn.
    const double stray = std::min(angle, 2.0) * reach + room;
    const Span3 extent = extent_of(local, m.start.orientation);
    const auto span = [&](double p, double c, double low, double high, double d) {
        const double min = std::max(p + low - stray, c - ball), max = std::min(p + high + stray, c + ball);
        return Interval{min + std::min(d, 0.0), max + std::max(d, 0.0)};
    };
    const Interval x = span(at.x, pivot.x, extent.min.x, extent.max.x, by.x),
                   y = span(at.y, pivot.y, extent.min.y, extent.max.y, by.y),
                   z = span(at.z, pivot.z, extent.min.z, extent.max.z, by.z);
    s.box = outwards({x.low, y.low, z.low}, {x.high, y.high, z.high});
    return s;
}

double farthest_from_origin(const Shape& shape) { return reach_about(core_of(shape), {}); }

V3 midway(const Body& body)
{
    const Motion& m = body.motion;
    return load(m.start.position) + arm_of(m) + 0.5 * load(m.translation);
}

Box3f standing(const Shape& shape, const Pose& pose, V3 origin)
{
    return sweep({shape, Motion::still(pose)}, origin).box;
}

} // namespace brink
