// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "exact.h"
#include "vector.h"

#include <brink/motion.h>

#include <optional>

namespace brink {

/// Two bodies that only translate, seen from B: world axes, origin at B's. Lengths between 2^-60 and 2^60, or
/// so much smaller than others that they do not matter.
struct Approach {
    V3 from; // A's origin at t = 0, rounded
    V3 by;   // A's motion relative to B over the whole step, rounded
    double target_gap;
    double t_max;
    const Motion& motion_a; // of a sphere the orientation is not looked at
    const Motion& motion_b;

    /// Local axes to world axes.
    Rotation turn_a() const { return rotation(motion_a.start.orientation); }
    Rotation turn_b() const { return rotation(motion_b.start.orientation); }

    /// What rounding left off `from` and off `by`.
    V3 from_low() const { return difference_low(motion_a.start.position, motion_b.start.position); }
    V3 by_low() const { return difference_low(motion_a.translation, motion_b.translation); }

private:
    static V3 difference_low(const Vec3& u, const Vec3& v)
    {
        const V3 a = load(u), b = load(v);
        return {two_difference(a.x, b.x).lo, two_difference(a.y, b.y).lo, two_difference(a.z, b.z).lo};
    }
};

/// What a closed form has proven about [0, t_max].
enum class Found : unsigned char {
    apart, // no contact
    start, // contact at t = 0
    hit,   // apart before t, in contact by t_upper
    doubt, // apart before t, no more than that
};

/// How two shapes meet at a time, in Approach's frame.
struct Meeting {
    V3 core_a, core_b; // where the cores (the shapes without their radius) come nearest
    V3 facing; // of any length, from A towards B: the axis of the proof. It is the normal where the cores
    bool flat; // themselves touch, and everywhere on a face
};

/// First contact of two shapes under translation, as a closed form finds it.
struct Entry {
    Found found = Found::doubt;
    double t = 0;
    double t_upper = infinity;
    /// At t, for a hit. In doubt: whether contact, which comes by t_upper, comes by t_max.
    std::optional<Meeting> meeting{};
};

} // namespace brink
