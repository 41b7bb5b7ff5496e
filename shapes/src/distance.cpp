// SPDX-License-Identifier: BSD-3-Clause
#include <brink/distance.h>

#include "placed_shape.h"
#include "validity.h"

namespace brink {

Distance distance(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b)
{
    if (!valid(a, pose_a) || !valid(b, pose_b)) return {};
    const auto s = separation(a, pose_a, b, pose_b);
    if (!s) return {};
    return {s->gap > 0 ? Status::separated : Status::touching, s->gap, store(s->normal), store(s->point_a),
            store(s->point_b)};
}

} // namespace brink
