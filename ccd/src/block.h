// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/scene.h>

#include <cstdint>
#include <limits>

/// What the broad phase reads: sixteen bodies side by side, in floats that are rounded outwards.
namespace brink {

inline constexpr int lanes = 16;
/// A set of lanes.
using Mask = std::uint32_t;
inline constexpr Mask all_lanes = 0xffff;
inline constexpr std::uint32_t no_slot = 0xffffffff;

/// The groups that some bodies are in and those that they meet, taken together.
struct Groups {
    std::uint32_t category = 0xffffffff, mask = 0xffffffff;
};
/// Whether two bodies meet, or any of some with any of others may.
static constexpr bool may_meet(const Groups& a, const Groups& b)
{
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}
static constexpr Groups operator|(const Groups& a, const Groups& b)
{
    return {a.category | b.category, a.mask | b.mask};
}

struct Box3f {
    float min[3], max[3];
};

/// A lane that holds nothing is NaN, which no comparison lets pass.
inline constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

struct alignas(64) Boxes {
    float min[3][lanes], max[3][lanes];
};

/// Balls about the pivots that hold the bodies whatever their turns, and how they travel over the step.
struct alignas(64) Balls {
    float from[3][lanes], by[3][lanes], radius[lanes];
};

/// What is kept of one body's sweep over the step, relative to the scene's origin.
struct Sweep {
    Box3f box{};
    float from[3]{}, by[3]{}, radius = 0;
};

static constexpr void put(Boxes& boxes, int lane, const Box3f& box)
{
    for (int axis = 0; axis < 3; ++axis) {
        boxes.min[axis][lane] = box.min[axis];
        boxes.max[axis][lane] = box.max[axis];
    }
}
static constexpr void put(Balls& balls, int lane, const Sweep& sweep)
{
    for (int axis = 0; axis < 3; ++axis) {
        balls.from[axis][lane] = sweep.from[axis];
        balls.by[axis][lane] = sweep.by[axis];
    }
    balls.radius[lane] = sweep.radius;
}
static inline Box3f box_at(const Boxes& boxes, int lane)
{
    Box3f box;
    for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = boxes.min[axis][lane];
        box.max[axis] = boxes.max[axis][lane];
    }
    return box;
}

inline constexpr Box3f empty_box{{nothing, nothing, nothing}, {nothing, nothing, nothing}};

/// The least box around all lanes that hold something; empty if none does.
static inline Box3f bound_of(const Boxes& boxes)
{
    Box3f bound;
    const auto lesser = [](float x, float y) { return x < y ? x : y; }; // NaN loses if it is x
    const auto greater = [](float x, float y) { return x > y ? x : y; };
    for (int axis = 0; axis < 3; ++axis) {
        constexpr float inf = std::numeric_limits<float>::infinity();
        float low[4]{inf, inf, inf, inf}, high[4]{-inf, -inf, -inf, -inf}; // four at a time
        for (int lane = 0; lane < lanes; lane += 4)
            for (int i = 0; i < 4; ++i) {
                low[i] = lesser(boxes.min[axis][lane + i], low[i]);
                high[i] = greater(boxes.max[axis][lane + i], high[i]);
            }
        bound.min[axis] = lesser(lesser(low[0], low[1]), lesser(low[2], low[3]));
        bound.max[axis] = greater(greater(high[0], high[1]), greater(high[2], high[3]));
    }
    return bound.min[0] <= bound.max[0] ? bound : empty_box;
}

} // namespace brink
