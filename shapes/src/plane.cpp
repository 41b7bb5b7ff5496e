// SPDX-License-Identifier: BSD-3-Clause
#include <brink/plane.h>

#include "nearest.h"
#include "scaling.h"

namespace brink {

namespace {

/// The unit normal of a triangle whatever the lengths of its edges; zero where they are parallel up to
/// rounding.
V3 unit_normal(const Leaning& t)
{
    const V3 e = mantissa(t.apex - t.p), f = mantissa(t.apex - t.q);
    const V3 n = cross(e, f);
    const double limit = tolerance::parallel * tolerance::parallel;
    if (!(norm_squared(n) > limit * norm_squared(e) * norm_squared(f))) return {};
    const V3 upright = mantissa(across(n, mantissa(t.q - t.p)));
    return (1 / norm(upright)) * upright;
}

} // namespace

Plane Plane::through(const Vec3& a, const Vec3& b, const Vec3& c)
{
    const V3 p = load(a), q = load(b), r = load(c);
    if (finite_probe(p) + finite_probe(q) + finite_probe(r) != 0) return {{0, 0, 0}, 0};
    const int e =
        exponent(std::max(largest_coordinate(p), std::max(largest_coordinate(q), largest_coordinate(r))));
    const V3 normal = unit_normal(leaning(scaled(p, -e), scaled(q, -e), scaled(r, -e)));
    return {store(normal), std::ldexp(dot(normal, scaled(p, -e)), e)};
}

} // namespace brink
