// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.h"

#include <algorithm>
#include <numeric>

namespace brink::support {
namespace {

constexpr double cells = 2'097'152; // along each axis: 21 bits

/// The lowest 21 bits, two zeros after each.
std::uint64_t spread(std::uint64_t x)
{
    x = (x | x << 32U) & 0x001f00000000ffffU;
    x = (x | x << 16U) & 0x001f0000ff0000ffU;
    x = (x | x << 8U) & 0x100f00f00f00f00fU;
    x = (x | x << 4U) & 0x10c30c30c30c30c3U;
    return (x | x << 2U) & 0x1249249249249249U;
}

std::vector<std::uint64_t> morton_codes(const std::vector<Body>& bodies)
{
    Vec3 least(infinity, infinity, infinity), most = -least;
    for (const Body& body : bodies) {
        least = least.cwiseMin(body.motion.start.position);
        most = most.cwiseMax(body.motion.start.position);
    }
    const double edge = std::max((most - least).maxCoeff(), 1e-300);
    std::vector<std::uint64_t> codes;
    codes.reserve(bodies.size());
    for (const Body& body : bodies) {
        std::uint64_t code = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double along = (body.motion.start.position[axis] - least[axis]) / edge;
            const double cell = std::min(along * cells, cells - 1);
            code |= spread(static_cast<std::uint64_t>(cell)) << static_cast<unsigned>(axis);
        }
        codes.push_back(code);
    }
    return codes;
}

Motion after(const Motion& m, const Vec3& translation)
{
    return {m.at(1), translation, -m.rotation, m.pivot};
}

} // namespace

SceneSample in_spatial_order(const SceneSample& sample)
{
    const std::vector<std::uint64_t> codes = morton_codes(sample.bodies);
    std::vector<std::size_t> order(codes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return codes[a] < codes[b]; });
    SceneSample sorted;
    for (const std::size_t i : order) {
        sorted.bodies.push_back(sample.bodies[i]);
        sorted.aside.push_back(sample.aside[i]);
    }
    return sorted;
}

std::vector<BodyId> movers(const SceneSample& sample)
{
    std::vector<BodyId> ids;
    for (std::size_t i = 0; i < sample.bodies.size(); ++i)
        if (!sample.bodies[i].immovable && !sample.bodies[i].asleep) ids.push_back(static_cast<BodyId>(i));
    return ids;
}

std::vector<Motion> motions_at(const SceneSample& sample, const std::vector<BodyId>& ids, int step)
{
    std::vector<Motion> motions;
    motions.reserve(ids.size());
    for (const BodyId id : ids) {
        const Motion& first = sample.bodies[id].motion;
        const Vec3& aside = sample.aside[id];
        const std::array<Vec3, 4> sides{first.translation, aside, -first.translation, -aside};
        Motion motion = first;
        for (std::size_t i = 1; i <= static_cast<std::size_t>(step % 4); ++i)
            motion = after(motion, sides[i]);
        motions.push_back(motion);
    }
    return motions;
}

} // namespace brink::support
