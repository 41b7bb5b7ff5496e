// SPDX-License-Identifier: BSD-3-Clause
#include <brink/overlap.h>

#include "dyadic.h"
#include "placed_shape.h"
#include "tolerance.h"
#include "validity.h"

#include <algorithm>

namespace brink {

namespace {

/// Whether two balls share a point: the exact answer for the doubles given.
bool balls_overlap(V3 centre_a, double radius_a, V3 centre_b, double radius_b)
{
    const V3 offset = centre_b - centre_a;
    const double distance = norm_squared(offset), radii = radius_a + radius_b, reach = radii * radii;
    const double scale = distance + reach;
    const bool usual = scale > tolerance::least_square && scale < tolerance::largest_square;
    if (usual && std::fabs(distance - reach) > tolerance::tight * scale) return distance < reach;

    using Exact = Dyadic<160>; // a square of doubles over all of their range, and a sum of such
    const auto square = [](const Exact& x) { return x * x; };
    return (square(Exact(centre_b.x) - Exact(centre_a.x)) + square(Exact(centre_b.y) - Exact(centre_a.y)) +
            square(Exact(centre_b.z) - Exact(centre_a.z)) - square(Exact(radius_a) + Exact(radius_b)))
               .sign() <= 0;
}

} // namespace

bool overlaps(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b)
{
    if (!valid(a, pose_a) || !valid(b, pose_b)) return true;
    const auto* ball_a = std::get_if<Sphere>(&a);
    const auto* ball_b = std::get_if<Sphere>(&b);
    if (ball_a != nullptr && ball_b != nullptr)
        return balls_overlap(load(pose_a.position), ball_a->radius, load(pose_b.position), ball_b->radius);
    const auto s = separation(a, pose_a, b, pose_b);
    return !s || s->gap <= 0;
}

} // namespace brink
