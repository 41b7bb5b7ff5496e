// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/toi.h>

namespace brink::support {

/// A body that starts at `position`, unturned, and moves by `translation` over the step.
inline Motion moving(const Vec3& position, const Vec3& translation)
{
    return {.start = {position, Quat(1, 0, 0, 0)}, .translation = translation};
}

/// A body at rest at `position`, unturned.
inline Motion resting(const Vec3& position = Vec3(0, 0, 0)) { return moving(position, Vec3(0, 0, 0)); }

/// Whether contact at time t lies in the answer's bracket, which must be as narrow as a few dozen roundings.
inline bool brackets(const Toi& toi, double t)
{
    return toi.status == Status::hit && toi.t <= t && t <= toi.t_upper && toi.t_upper - toi.t <= 0x1p-43;
}

/// Whether two points are the same but for that.
inline bool near(const Vec3& a, const Vec3& b) { return (a - b).norm() <= 0x1p-40; }

} // namespace brink::support
