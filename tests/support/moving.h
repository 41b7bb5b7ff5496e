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

} // namespace brink::support
