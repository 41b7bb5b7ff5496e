// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "validity.h"

#include <brink/motion.h>

namespace brink {

inline constexpr double largest_rotation = 0x1p20; // radians

/// Everything about a motion but the orientation, which some shapes do not have.
static inline bool valid_path(const Motion& m)
{
    const double probe = finite_probe(load(m.start.position)) + finite_probe(load(m.translation)) +
                         finite_probe(load(m.pivot));
    return probe == 0 && norm_squared(load(m.rotation)) <= largest_rotation * largest_rotation;
}

/// Whether the body only translates whatever its rotation: a sphere on its pivot.
static inline bool on_pivot(const Sphere&, const Motion& m) { return load(m.pivot) == V3{}; }
template <class Shape> bool on_pivot(const Shape&, const Motion&) { return false; }

template <class Shape> bool valid(const Shape& shape, const Motion& m)
{
    return valid(shape) && valid_path(m) && (on_pivot(shape, m) || valid(m.start.orientation));
}

/// Whether the body turns in a way that its shape shows.
template <class Shape> bool turns(const Shape& shape, const Motion& m)
{
    return !(load(m.rotation) == V3{}) && !on_pivot(shape, m);
}

static inline bool valid(const Shape& shape, const Motion& m)
{
    return !shape.valueless_by_exception() && std::visit([&](const auto& s) { return valid(s, m); }, shape);
}

} // namespace brink
