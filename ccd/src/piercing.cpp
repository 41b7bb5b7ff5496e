// SPDX-License-Identifier: BSD-3-Clause
#include "piercing.h"

#include "depth.h"
#include "falling.h"
#include "flattest_edge.h"
#include "support.h"

#include <algorithm>

namespace brink {

namespace {

/// The part of the depth by which a point may be less deep than the deepest of a line.
constexpr double nearly_deepest = 0x1p-4;

Drift drift(const Piercing& p, V3 point) { return drift(p.of, p.solid, p.velocity, point, p.solid.reach); }

/// As long as a point that goes with its body stays inside.
double stays(const Piercing& p, V3 point)
{
    const Drift d = drift(p, point);
    return last_kept([&](double h) { return depth(p.solid.part, point + h * d.velocity); }, d.acceleration,
                     p.horizon);
}

/// As long as one does that goes straight through its body, from one place to another.
double slides(const Piercing& p, V3 from, V3 to, double until)
{
    const V3 slide = (1 / until) * (to - from), velocity = drift(p, from).velocity + slide;
    const double of = p.of.angle, solid = p.solid.angle, slip = norm(slide);
    const double arm = std::max(norm(from - p.of.pivot), norm(to - p.of.pivot));
    const double speed = of * arm + norm(p.velocity) + slip;
    const double acceleration =
        of * of * arm + 2 * of * slip + 2 * solid * speed + solid * solid * p.solid.reach;
    return last_kept([&](double h) { return depth(p.solid.part, from + h * velocity); }, acceleration, until);
}

/// Of a point of one core, that which is nearest to the middle of a solid, and those between, the deepest in
/// the solid.
V3 deepest(const Core& of, const Core& solid, V3 point)
{
    Core target;
    target.points[0] = middle(solid);
    const Separation s = separation(of, target);
    const bool apart = s.gap + of.radius > 0;
    const V3 way = (apart ? s.point_a - of.radius * s.normal : target.points[0]) - point;
    const auto depth_at = [&](double part) { return depth(solid, point + part * way); }; // concave
    const auto enough = [](double width, double) { return width <= 0x1p-7; };
    return point + highest_place(depth_at, 0, 1, enough) * way;
}

/// One that lies flat against an axis: an edge, or a side of a cylinder or cone.
Segment flat_stretch(const Core& c, V3 axis)
{
    if (has_rim(c)) return side(c, axis);
    if (!has_edges(c)) return {};
    const FlatEdge edge = flattest_edge(c, axis);
    return {edge.top, edge.length * edge.along};
}

/// Where the rim of a cylinder or cone lies farthest along an axis, a chord that cuts off little of what
/// overlaps there.
Segment rim_chord(const Core& c, V3 axis, double overlap)
{
    if (!has_rim(c)) return {};
    const V3 h = c.half_extents, z = c.axes.z, out = outwards(c, axis);
    const double cut = std::clamp(0.0625 * overlap, 0.0, h.x);
    const V3 half = std::sqrt(cut * (2 * h.x - cut)) * cross(z, out);
    const double up = c.kind == Core::Kind::cylinder && dot(axis, z) > 0 ? h.z : -h.z;
    return {c.centre + up * z + (h.x - cut) * out - half, 2 * half};
}

/// As long as a point stays inside that goes along a line, from where that is deepest now to where it will be
/// when the shortest way out has become zero.
double crosses(const Piercing& p, const Segment& line)
{
    const double length = norm(line.edge);
    if (!(length > 0)) return 0;
    const auto at = [&](double part) { return line.start + part * line.edge; };
    const auto deepest_after = [&](double h) {
        const auto depth_at = [&](double part) {
            const V3 point = at(part);
            return depth(p.solid.part, point + h * drift(p, point).velocity);
        };
        const auto enough = [&](double width, double highest) { // depth changes no faster than the place
            const double more = width * length;
            return more <= nearly_deepest * highest || highest + more < 0 || width <= 0x1p-50;
        };
        return at(highest_place(depth_at, 0, 1, enough));
    };
    const V3 now = deepest_after(0);
    const double deep = depth(p.solid.part, now);
    if (!(deep > 0)) return 0;
    const Drift d = drift(p, now);
    const double out = falls(std::max(deep, p.overlap), -dot(d.velocity, p.outward), d.acceleration);
    const double until = std::min(p.horizon, out);
    return until > 0 ? slides(p, now, deepest_after(until), until) : 0;
}

} // namespace

double piercing_step(const Piercing& p, V3 point)
{
    if (p.solid.part.kind <= Core::Kind::triangle) return 0;
    double step = stays(p, point);
    const auto attempt = [&](const auto& witness) {
        if (step < p.horizon) step = std::max(step, witness());
    };
    attempt([&] { return stays(p, deepest(p.of.part, p.solid.part, point)); });
    attempt([&] { return crosses(p, flat_stretch(p.of.part, -p.outward)); });
    attempt([&] { return crosses(p, rim_chord(p.of.part, -p.outward, p.overlap)); });
    return step;
}

} // namespace brink
