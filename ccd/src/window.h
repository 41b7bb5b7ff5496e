// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mover.h"
#include "support.h"
#include "tolerance.h"

#include <brink/toi.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace brink {

/// The part of [0, 1] in which two bodies can touch at all.
struct Window {
    double begin = 0, end = 1;
    bool empty = false;
};

/// When the balls about both pivots that hold the bodies meet and part: any number of turns, one quadratic.
static inline Window meeting(V3 from, V3 by, double radius)
{
    const double grown =
        radius + tolerance::clip_slack * (sum_of_magnitudes(from) + sum_of_magnitudes(by) + radius);
    const double c = norm_squared(from) - grown * grown, along = dot(from, by), a = norm_squared(by);
    if (c > 0 && along >= 0) return {.empty = true};
    const double discriminant = a * grown * grown - norm_squared(cross(from, by));
    const double root = std::sqrt(std::max(0.0, discriminant));
    Window w;
    if (c > 0) {
        if (discriminant < 0) return {.empty = true};
        w.begin = c / (root - along) * (1 - tolerance::clip_slack);
    }
    const double end = along > 0 ? c / (-along - root) : (root - along) / a;
    if (end < 1) w.end = end * (1 + tolerance::clip_slack);
    w.empty = !(w.begin <= 1);
    return w;
}

template <class Part>
static inline Window meeting(const Mover<Core>& a, const Mover<Part>& b, V3 from, V3 by, double target_gap)
{
    if constexpr (std::is_same_v<Part, Border>)
        return {};
    else
        return meeting(from, by, a.reach + b.reach + a.part.radius + b.part.radius + target_gap);
}

/// The same with room for all rounding, before anything is turned: whether bodies that turn about their
/// origins stay apart until t_max, whatever their turns. `radius`: those of balls about these that hold them,
/// added up.
static inline bool never_near(double radius, const Motion& a, const Motion& b, const Options& options)
{
    if (!(load(a.pivot) == V3{} && load(b.pivot) == V3{})) return false;
    const V3 from = load(b.start.position) - load(a.start.position);
    const V3 by = load(b.translation) - load(a.translation);
    const double grown = radius + options.target_gap;
    const double room = grown + sum_of_magnitudes(from) + sum_of_magnitudes(by);
    const Window w = meeting(from, by, grown + tolerance::clip_room * room);
    return w.empty || w.begin > options.t_max;
}

} // namespace brink
