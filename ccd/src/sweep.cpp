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

/// How far a shape extends from its own origin along the world's axes, and from its pivot in all directions.
struct Size {
    Span3 extent;
    double reach = 0;
};

V3 least(V3 a, V3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
V3 most(V3 a, V3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }
Span3 grown(V3 min, V3 max, double r)
{
    return {{min.x - r, min.y - r, min.z - r}, {max.x + r, max.y + r, max.z + r}};
}

Size size_of(const Sphere& s, const Rotation&, V3 pivot)
{
    return {grown({}, {}, s.radius), norm(pivot) + s.radius};
}
Size size_of(const Box& s, const Rotation& r, V3 pivot)
{
    const V3 h = load(s.half_extents),
             most = h.x * magnitudes(r.x) + h.y * magnitudes(r.y) + h.z * magnitudes(r.z);
    return {{-most, most}, norm(h + magnitudes(pivot))};
}
Size size_of(const Capsule& s, const Rotation& r, V3 pivot)
{
    const V3 a = load(s.a), b = load(s.b), at_a = r * a, at_b = r * b;
    const double reach = std::sqrt(std::max(norm_squared(a - pivot), norm_squared(b - pivot)));
    return {grown(least(at_a, at_b), most(at_a, at_b), s.radius), reach + s.radius};
}
Size size_of(const Plane&, const Rotation&, V3) { return {}; }
Size size_of(const HalfSpace&, const Rotation&, V3) { return {}; }
template <class Other> Size size_of(const Other& s, const Rotation& r, V3 pivot)
{
    const Core local = core(s), turned = placed(local, r, {});
    const Interval x = interval(turned, {1, 0, 0}), y = interval(turned, {0, 1, 0}),
                   z = interval(turned, {0, 0, 1});
    const double reach = brink::reach(pivot == V3{} ? local : placed(local, {}, -pivot));
    return {grown({x.low, y.low, z.low}, {x.high, y.high, z.high}, local.radius), reach + local.radius};
}

/// Of a sphere on its pivot the rotation need not be known, nor valid.
bool turns_in_place(const Shape& shape, V3 pivot)
{
    return std::holds_alternative<Sphere>(shape) && pivot == V3{};
}

V3 arm_of(const Motion& m)
{
    const V3 pivot = load(m.pivot);
    return pivot == V3{} ? V3{} : rotation(m.start.orientation) * pivot;
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
    const V3 by = load(m.translation), turn = load(m.rotation), centre = load(m.pivot);
    const Rotation r = turns_in_place(body.shape, centre) ? Rotation{} : rotation(m.start.orientation);
    const auto [extent, reach] = std::visit([&](const auto& s) { return size_of(s, r, centre); }, body.shape);
    const V3 arm = centre == V3{} ? V3{} : r * centre;
    const V3 at = load(m.start.position) - origin, pivot = at + arm;
    const double angle = turn == V3{} ? 0 : norm(turn);
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

double farthest_from_origin(const Shape& shape)
{
    return std::visit([](const auto& s) { return size_of(s, {}, {}).reach; }, shape);
}

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
