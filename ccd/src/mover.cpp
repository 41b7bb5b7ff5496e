// SPDX-License-Identifier: BSD-3-Clause
#include "mover.h"

#include "support.h"
#include "tolerance.h"

#include <type_traits>

namespace brink {

namespace {

/// Whether the core is given by its corners; else by its axes and centre.
bool by_corners(const Core& c) { return c.kind <= Core::Kind::triangle; }

void prepare(Mover<Core>& m)
{
    const Core& c = m.part;
    if (by_corners(c)) {
        m.vectors[0] = {pair(c.points[0], c.points[1]), m.turn};
        if (c.count > 2) m.vectors[1] = {pair(c.points[2], {}), m.turn};
        return;
    }
    m.vectors[0] = {pair(c.axes.x, c.axes.y), m.turn};
    m.vectors[1] = {pair(c.axes.z, c.centre), m.turn};
}
void prepare(Mover<Border>& m) { m.vectors[0] = {both(m.part.normal), m.turn}; }

/// Puts a part as it starts, given in its own frame, about its pivot.
void start(Core& c, const Rotation& start, V3 pivot)
{
    if (by_corners(c)) {
        // A sphere on its pivot: its orientation was never looked at, and may be anything.
        if (c.kind == Core::Kind::point && c.points[0] == pivot) {
            c.points[0] = {};
            return;
        }
        for (int k = 0; k < c.count; ++k)
            c.points[k] = start * (c.points[k] - pivot);
        return;
    }
    const double unit = c.axes.x.x; // a hull's length; its own axes are not turned
    c.axes = {unit * start.x, unit * start.y, unit * start.z};
    if (!(c.centre == pivot)) c.centre = start * (c.centre - pivot);
}
void start(Border& b, const Rotation& start, V3 pivot) { b = placed(placed(b, {}, -pivot), start, {}); }

} // namespace

Core thinned(const Core& round)
{
    const V3 h = round.half_extents;
    const bool x = h.x > 0, y = h.y > 0, z = h.z > 0;
    if ((x && y) || (y && z) || (z && x)) return round;
    Core c;
    c.radius = round.radius;
    if (!x && !y && !z) return c;
    c.kind = Core::Kind::segment;
    c.count = 2;
    c.points[0] = -h;
    c.points[1] = h;
    return c;
}

Turn turn(const Vec3& rotation)
{
    const V3 rate = load(rotation);
    const double angle = norm(rate);
    if (!(angle > 0)) return {};
    return {rate, {rate.x / angle, rate.y / angle, rate.z / angle}, angle};
}

Turning::Turning(const XYZ<Two>& vectors, const Turn& turn)
{
    const XYZ<Two> axis = both(turn.axis);
    still = dot(axis, vectors) * axis;
    cosine = vectors - still;
    sine = cross(axis, vectors);
}

Rotation turned(const Turn& turn, double t) { return turned(turn, sin_cos(t * turn.angle)); }

Rotation turned(const Turn& turn, SinCos at)
{
    if (at.sin == 0 && at.cos == 1) return {};
    const V3 k = turn.axis, sk = at.sin * k, ck = (1 - at.cos) * k;
    return {{at.cos + ck.x * k.x, ck.x * k.y + sk.z, ck.x * k.z - sk.y},
            {ck.y * k.x - sk.z, at.cos + ck.y * k.y, ck.y * k.z + sk.x},
            {ck.z * k.x + sk.y, ck.z * k.y - sk.x, at.cos + ck.z * k.z}};
}

template <> void Mover<Core>::place(Core& copy, SinCos turned, V3 at) const
{
    const bool still = turn.angle == 0;
    if (still && !by_corners(part)) {
        copy.centre = part.centre + at;
    } else if (still) {
        for (int k = 0; k < part.count; ++k)
            copy.points[k] = part.points[k] + at;
    } else if (by_corners(part)) {
        const XYZ<Two> ends = vectors[0].at(turned) + both(at);
        copy.points[0] = first(ends);
        copy.points[1] = second(ends);
        if (part.count > 2) copy.points[2] = first(vectors[1].at(turned)) + at;
    } else {
        const XYZ<Two> xy = vectors[0].at(turned), rest = vectors[1].at(turned);
        copy.axes = {first(xy), second(xy), first(rest)};
        copy.centre = second(rest) + at;
    }
}

template <> void Mover<Border>::place(Border& copy, SinCos turned, V3 at) const
{
    if (turn.angle > 0) copy.normal = first(vectors[0].at(turned));
    copy.offset = part.offset + dot(copy.normal, at);
}

template <class Part> void Mover<Part>::set_out(const Motion& motion)
{
    position = load(motion.start.position);
    translation = load(motion.translation);
    turn = brink::turn(motion.rotation);
    const V3 pivot = load(motion.pivot);
    const Rotation turned = rotation(motion.start.orientation);
    start(part, turned, pivot);
    if (!(pivot == V3{})) arm = turned * pivot;
    if constexpr (std::is_same_v<Part, Core>) {
        reach = brink::reach(part) * (1 + tolerance::holding_slack);
        if (reach == 0) turn = {};
    }
    if (turn.angle > 0) prepare(*this);
}

template struct Mover<Core>;
template struct Mover<Border>;

} // namespace brink
