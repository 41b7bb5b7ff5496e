// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core.h"

namespace brink {

/// separation() of two cores of any kind and any scale, their radii left out: GJK, and where that is not
/// certain or the cores overlap, separating axes and every pair of features. Several times slower than a
/// closed form.
Separation polytope_separation(const Core& a, const Core& b);

} // namespace brink
