// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector_of.h"

#include <brink/shape.h>

#include <optional>
#include <vector>

/// What the referee knows of a shape: its core, a closed convex set, and the radius it is grown by. T is
/// long double, or Hundred where there is MPFR.
namespace brink::support {

enum class Core : unsigned char { polytope, cloud, cylinder, cone, ellipsoid, plane, half_space };

/// A core in its own frame. Everything not named for its kind is empty or zero.
template <class T> struct Solid {
    struct Edge {
        std::size_t from, to; // of corners; the same twice for a point
    };
    struct Face {
        std::size_t at, u, v; // of corners: a triangle, or the parallelogram with the sides at-u and at-v
        bool whole = false;   // a parallelogram
    };
    Core core = Core::polytope;
    T radius = 0;
    std::vector<Vector<T>> corners; // polytope: all; cloud: of whose hull it is; others: of a box around it
    std::vector<Edge> edges;        // polytope
    std::vector<Face> faces;        // polytope
    Vector<T> radii;                // ellipsoid
    T half_length = 0, girth = 0;   // cylinder and cone, along z; girth: radius of their discs
    Vector<T> normal;               // plane, half-space: unit
    T offset = 0;                   // plane, half-space: along the unit normal

    bool unbounded() const { return core == Core::plane || core == Core::half_space; }
};

template <class T> Solid<T> solid(const Shape&);

/// A core somewhere. Points and directions are in the frame in which it was placed.
template <class T> struct Placement {
    const Solid<T>* solid = nullptr;
    Vector<T> origin; // where the local origin is
    Matrix<T> axes;
    std::vector<Vector<T>> corners; // of a polytope or cloud, placed
    Vector<T> normal;               // of a plane or half-space, placed
    T offset = 0;                   // normal . x = offset

    /// A point of the core that is farthest along the direction, which need not be a unit vector.
    Vector<T> support(const Vector<T>& direction) const;
};

template <class T> Placement<T> placed(const Solid<T>&, const Vector<T>& origin, const Matrix<T>& axes);

} // namespace brink::support
