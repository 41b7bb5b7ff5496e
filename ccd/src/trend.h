// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "certificate.h"
#include "falling.h"

/// How bodies near each other, as far as two of their points tell: what times are guessed from. No bound
/// rests on it.
namespace brink {

/// That between a point of A and one of B, which go with their bodies, along an axis.
template <class Part>
static inline Trend trend(const Facing<Part>& f, const TurningAxis& axis, V3 on_a, V3 on_b)
{
    const V3 n = axis.normal, way = on_b - on_a;
    const V3 growing = f.velocity + cross(f.b.rate, on_b - f.b.pivot) - cross(f.a.rate, on_a);
    return {dot(n, way) - f.margin, dot(n, growing) + dot(cross(axis.spin, n), way)};
}

} // namespace brink
