// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/aabb.h>
#include <brink/box.h>
#include <brink/capsule.h>
#include <brink/cone.h>
#include <brink/cylinder.h>
#include <brink/ellipsoid.h>
#include <brink/half_space.h>
#include <brink/hull.h>
#include <brink/plane.h>
#include <brink/pose.h>
#include <brink/sphere.h>
#include <brink/triangle.h>

#include <variant>

namespace brink {

/// One of brink's shapes, by value. Every shape is a closed, convex set: touching and tangency are contact.
/// (Passing a Hull where a Shape is asked for makes one, and counts the owners of its contents: keep Shapes.)
using Shape = std::variant<Sphere, Capsule, Box, Triangle, Plane, HalfSpace, Cylinder, Cone, Ellipsoid, Hull>;

/// The least box around a posed shape, rounded outwards: it contains every point of the shape.
/// Planes and half-spaces are unbounded: their sides are +-infinity, except along a world axis that their
/// normal is parallel to. Where an input is invalid, the box is all of space.
Aabb bounds(const Shape&, const Pose&);

} // namespace brink
