// SPDX-License-Identifier: BSD-3-Clause
#include "mover.h"

#include "support.h"
#include "tolerance.h"

namespace brink {

namespace {

Turning turning(V3 v, const Turn& turn)
{
    const V3 still = dot(turn.axis, v) * turn.axis;
    return {still, v - still, cross(turn.axis, v)};
}

/// Whether the core is given by its corners; else by its axes and centre.
bool by_corners(const Core& c) { return c.kind <= Core::Kind::triangle; }

void prepare(Mover<Core>& m)
{
    if (by_corners(m.part)) {
        for (int k = 0; k < m.part.count; ++k)
            m.vectors[k] = turning(m.part.points[k], m.turn);
        return;
    }
    m.vectors[0] = turning(m.part.axes.x, m.turn);
    m.vectors[1] = turning(m.part.axes.y, m.turn);
    m.vectors[2] = turning(m.part.axes.z, m.turn);
    m.vectors[3] = turning(m.part.centre, m.turn);
}
void prepare(Mover<Border>& m) { m.vectors[0] = turning(m.part.normal, m.turn); }

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

template <class Part> void start(Mover<Part>& m, const Motion& motion)
{
    const V3 pivot = load(motion.pivot);
    const Rotation turned = rotation(motion.start.orientation);
    start(m.part, turned, pivot);
    m.position = load(motion.start.position);
    if (!(pivot == V3{})) m.arm = turned * pivot;
    m.translation = load(motion.translation);
    m.turn = turn(motion.rotation);
}

} // namespace

Turn turn(const Vec3& rotation)
{
    const V3 rate = load(rotation);
    const double angle = norm(rate);
    if (!(angle > 0)) return {};
    return {rate, {rate.x / angle, rate.y / angle, rate.z / angle}, angle};
}

Rotation turned(const Turn& turn, double t)
{
    if (turn.angle == 0 || t == 0) return {};
    const SinCos at = sin_cos(t * turn.angle);
    const V3 k = turn.axis, sk = at.sin * k, ck = (1 - at.cos) * k;
    return {{at.cos + ck.x * k.x, ck.x * k.y + sk.z, ck.x * k.z - sk.y},
            {ck.y * k.x - sk.z, at.cos + ck.y * k.y, ck.y * k.z + sk.x},
            {ck.z * k.x + sk.y, ck.z * k.y - sk.x, at.cos + ck.z * k.z}};
}

template <> void Mover<Core>::place(Core& copy, double t, V3 at) const
{
    const bool still = turn.angle == 0;
    const SinCos a = still ? SinCos{0, 1} : sin_cos(t * turn.angle);
    if (by_corners(part)) {
        for (int k = 0; k < part.count; ++k)
            copy.points[k] = (still ? part.points[k] : vectors[k].at(a)) + at;
        return;
    }
    if (still) {
        copy.centre = part.centre + at;
        return;
    }
    copy.axes = {vectors[0].at(a), vectors[1].at(a), vectors[2].at(a)};
    copy.centre = vectors[3].at(a) + at;
}

template <> void Mover<Border>::place(Border& copy, double t, V3 at) const
{
    if (turn.angle > 0) copy.normal = vectors[0].at(sin_cos(t * turn.angle));
    copy.offset = part.offset + dot(copy.normal, at);
}

Mover<Core> mover(const Core& local, const Motion& motion)
{
    Mover<Core> m;
    m.part = local;
    start(m, motion);
    m.reach = reach(m.part) * (1 + tolerance::holding_slack);
    if (m.reach == 0) m.turn = {};
    if (m.turn.angle > 0) prepare(m);
    return m;
}

Mover<Border> mover(const Border& local, const Motion& motion)
{
    Mover<Border> m;
    m.part = local;
    start(m, motion);
    if (m.turn.angle > 0) prepare(m);
    return m;
}

} // namespace brink
