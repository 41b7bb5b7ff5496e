// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "exact.h"
#include "vector.h"

#include <brink/pose.h>

namespace brink {

/// Two bodies that only translate, seen from B: world axes, origin at B's.
struct Approach {
    V3 from; // A's origin at t = 0, rounded
    V3 by;   // A's motion relative to B over the whole step
    double target_gap;
    const Pose& pose_a; // at t = 0; the orientation of a sphere is not looked at
    const Pose& pose_b;

    /// Local axes to world axes.
    Rotation turn_a() const { return rotation(pose_a.orientation); }
    Rotation turn_b() const { return rotation(pose_b.orientation); }
    /// What rounding left off `from`.
    V3 from_low() const
    {
        const V3 a = load(pose_a.position), b = load(pose_b.position);
        return {two_difference(a.x, b.x).lo, two_difference(a.y, b.y).lo, two_difference(a.z, b.z).lo};
    }
};

/// First contact of two shapes under translation, as a closed form finds it.
struct Entry {
    double t = infinity; // 0: in contact at the start, with nothing else set; infinite: not in [0, 1]
    V3 core_a{};         // where the cores (the shapes without their radius) come nearest at t,
    V3 core_b{};         // in Approach's frame
    V3 facing{};         // of any length, from A towards B: the normal where the cores themselves touch,
    bool flat = false;   // and everywhere on a face
};

} // namespace brink
