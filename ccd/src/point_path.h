// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/motion.h>
#include <brink/shape.h>
#include <brink/toi.h>

#include <type_traits>

namespace brink {

/// Whether the distance of a point from a shape has a closed form.
template <class S>
constexpr bool has_closed_distance =
    std::is_same_v<S, Capsule> || std::is_same_v<S, Triangle> || std::is_same_v<S, Box> ||
    std::is_same_v<S, Cylinder> || std::is_same_v<S, Cone>;

/// First contact of a sphere that does not turn and such a shape that does. Seen from the shape the sphere's
/// centre runs along a curve past a convex set at rest, and the normal where it is nearest bounds the gap
/// both ways in time, on whatever feature that is (numerics.md section 1). None where the way begins within
/// the tolerance of contact, where the radii are nothing beside the other lengths, or after
/// `tolerance::most_passing` looks.
template <class S> Toi pass(const Sphere&, const Motion&, const S& shape, const Motion&, const Options&);

} // namespace brink
