// SPDX-License-Identifier: BSD-3-Clause
#include "spindle.h"

#include "depth.h"
#include "falling.h"
#include "nearest.h"
#include "support.h"

#include <algorithm>

namespace brink {

namespace {

/// A part of the way in which a hub is looked for: it is a guess.
constexpr double near_enough = 0x1p-9;

bool is_thin(const Core& c) { return c.kind == Core::Kind::point || c.kind == Core::Kind::segment; }

V3 nearest_of_thin(const Core& c, V3 p)
{
    if (c.kind == Core::Kind::point) return c.points[0];
    return p + to_segment(c.points[0] - p, c.points[1] - p);
}

/// What tells where to look for a point deep in a core, concave.
double depth_guessed(const Core& c, V3 p)
{
    if (is_thin(c)) return -norm(nearest_of_thin(c, p) - p);
    return c.kind == Core::Kind::triangle ? -norm(middle(c) - p) : depth(c, p);
}

/// How deep a point lies in a core, or less than that; its distance if negative.
double depth_known(const Core& c, V3 p)
{
    const double guessed = depth_guessed(c, p);
    if (guessed > 0 || is_thin(c)) return guessed;
    Core at;
    at.points[0] = p;
    return std::min(0.0, -(separation(at, c).gap + c.radius));
}

/// A point that the turns of a body leave where it is, and how deep in the core it lies. However the body
/// turns, the ball of that radius lies within; or some point of the body is as far from there as that is
/// negative.
struct Hub {
    V3 at;
    double depth;
};

/// Where on the axis of a body's turn the depth and another concave function have the largest sum; of a body
/// that does not turn, on the line from its pivot to some point.
template <class Other> Hub best_hub(const Posed<Core>& body, V3 towards, const Other& other)
{
    const bool turns = body.angle > 0;
    const V3 by = turns ? (body.reach / body.angle) * body.rate : towards - body.pivot;
    const auto sum = [&](double s) {
        const V3 p = body.pivot + s * by;
        return depth_guessed(body.part, p) + other(p);
    };
    const V3 at = body.pivot + highest_place(sum, turns ? -1 : 0, 1, [](double width, double) {
                                   return width <= near_enough;
                               }) * by;
    return {at, depth_known(body.part, at)};
}

/// As long as what goes with the other body from here, its point at the hub or nearest to it, stays near
/// enough: `velocity` is that of its pivot, as the hub sees it.
double beside(const Posed<Core>& other, V3 velocity, const Hub& hub, double reach, double horizon)
{
    const Core& c = other.part;
    if (!is_thin(c) && !(depth_guessed(c, hub.at) > 0)) return 0;
    const V3 p = is_thin(c) ? nearest_of_thin(c, hub.at) : hub.at;
    const V3 swing = cross(other.rate, p - other.pivot), from = p - hub.at, speed = velocity + swing;
    const double bend = other.angle * norm(swing), room = reach + hub.depth;
    return last_kept([&](double h) { return room - norm(from + h * speed); }, bend, horizon);
}

} // namespace

double spindle_step(const Facing<Core>& f, double reach, double horizon)
{
    const auto within = [](const Core& c) { return [&c](V3 p) { return depth_guessed(c, p); }; };
    const Hub in_a = best_hub(f.a, f.b.pivot, within(f.b.part));
    const Hub in_b = best_hub(f.b, f.a.pivot, within(f.a.part));
    const Hub opposite = best_hub(f.a, in_b.at, [&](V3 p) { return -norm(p - in_b.at); });
    const V3 way = in_b.at - opposite.at;
    const double room = opposite.depth + in_b.depth + reach;
    return std::max({beside(f.b, f.velocity, in_a, reach, horizon),
                     beside(f.a, -f.velocity, in_b, reach, horizon),
                     last_kept([&](double h) { return room - norm(way + h * f.velocity); }, 0, horizon)});
}

double spindle_step(const Facing<Border>& f, double reach, double horizon)
{
    const Border& border = f.b.part;
    const V3 n = border.normal, axis = f.b.angle > 0 ? (1 / f.b.angle) * f.b.rate : n;
    const double along = dot(n, axis), across = norm(cross(n, axis));
    const double level = border.offset - dot(n, f.b.pivot);
    // How far a point comes to lie beyond, at most; of a plane on either side.
    const auto beyond = [&](V3 p) {
        const V3 arm = p - f.b.pivot;
        const double height = along * dot(arm, axis), swing = across * norm(cross(arm, axis));
        const double above = height + swing - level;
        return border.solid ? above : std::max(above, level - (height - swing));
    };
    const Hub hub = best_hub(f.a, f.b.pivot, [&](V3 p) { return -beyond(p); });
    return last_kept([&](double h) { return reach + hub.depth - beyond(hub.at - h * f.velocity); }, 0,
                     horizon);
}

} // namespace brink
