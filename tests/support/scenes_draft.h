// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "random.h"
#include "scenes.h"

/// What draw_scene is made of.
namespace brink::support {

/// Newton's method, because std::cbrt differs between libraries in its last bit. x > 0.
double cube_root(double x);

/// The edge of the cube in which n boxes of edge `width`, thrown at random, have `pairs` overlapping pairs a
/// body: two of them meet with probability 2 u - u^2 along each axis, u = width / edge.
double edge_for(std::size_t n, double width, double pairs);

/// Uniform in the box.
Vec3 in_box(Random&, const Vec3& min, const Vec3& max);

void add(SceneSample&, const Body&, const Vec3& aside = Vec3{0, 0, 0});

SceneSample gas(Random&, std::size_t n);
SceneSample clustered(Random&, std::size_t n);
SceneSample asleep(Random&, std::size_t n);

} // namespace brink::support
