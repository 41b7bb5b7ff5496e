// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query.h"
#include "vector_of.h"

#include <vector>

/// Moving shapes in doubles, for the quick judge. As "What the doubles mean" of the design has it; shares no
/// code with brink.
namespace brink::support {

using Quick3 = Vector<double>;

/// A core in its own frame, about the pivot, and how it moves.
struct QuickBody {
    enum class Kind : unsigned char { points, cylinder, cone, ellipsoid, ground };
    Kind kind = Kind::points;
    bool two_sided = false;     // of ground: a plane
    double radius = 0;          // what the core is grown by
    std::vector<Quick3> points; // of whose hull the core is; else empty
    std::vector<double> reach,
        swing;     // of each point, or of each part: from the pivot, from the axis turned about
    Quick3 centre; // of a curved core, from the pivot
    Quick3 radii;  // ellipsoid
    double half_length = 0, girth = 0;
    Quick3 normal;     // of ground, unit
    double offset = 0; // of ground, from the pivot
    Quick3 pivot, velocity, rotation;
    double rate = 0;   // |rotation|
    double extent = 0; // of the core from the local origin, with the pivot's distance and the radius
    Matrix<double> start;
};

/// `origin` is taken off the positions before anything is rounded.
QuickBody quick_body(const Shape&, const Motion&, const Vec3& origin);

/// A body at one time. Points are in the world's axes, from its pivot.
struct QuickPlace {
    const QuickBody* body = nullptr;
    Quick3 pivot;
    Matrix<double> axes;
    std::vector<Quick3> points;
    Quick3 centre, normal;

    QuickPlace(const QuickBody&, double t);

    /// A point of the core that is least along d, which need not be a unit vector, and which one it is.
    struct Least {
        Quick3 point;
        std::size_t index = 0;
    };
    Least least(const Quick3& d) const;

    /// Of one part of a curved core, which is the hull of its parts: cylinder, its two discs; cone, its apex
    /// and its disc; ellipsoid, itself.
    Quick3 least_of_part(std::size_t part, const Quick3& d) const;
};

} // namespace brink::support
