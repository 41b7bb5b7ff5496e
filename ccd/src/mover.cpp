// SPDX-License-Identifier: BSD-3-Clause
#include "mover.h"

#include "support.h"
#include "tolerance.h"
#include "trig.h"

namespace brink {

namespace {

template <class Part> Mover<Part> started(const Part& local, const Motion& motion)
{
    const V3 pivot = load(motion.pivot);
    const Rotation start = rotation(motion.start.orientation);
    Mover<Part> m;
    m.part = placed(placed(local, {}, -pivot), start, {});
    m.position = load(motion.start.position);
    m.arm = pivot == V3{} ? V3{} : start * pivot;
    m.translation = load(motion.translation);
    m.turn = turn(motion.rotation);
    return m;
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

Mover<Core> mover(const Core& local, const Motion& motion)
{
    Mover<Core> m = started(local, motion);
    m.reach = reach(m.part) * (1 + tolerance::holding_slack);
    if (m.reach == 0) m.turn = {};
    return m;
}

Mover<Border> mover(const Border& local, const Motion& motion) { return started(local, motion); }

} // namespace brink
