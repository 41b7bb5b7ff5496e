// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "course.h"
#include "sight.h"

namespace brink {

/// The contact here: from the last look, a closer one, or all over.
Separation contact_at(const Course<Core>&, Watch&, const Sight&);
Separation contact_at(const Course<Border>&, const BorderWatch&, const Sight&);

/// A time after now, at most t_max, by which contact has begun for certain; infinity where that is not
/// proven. `sight` shows a pair of witness points within the tolerance of contact. The course may be moved,
/// and is back where it was.
double contact_by(Course<Core>&, const Watch&, const Sight&);
double contact_by(Course<Border>&, const BorderWatch&, const Sight&);

} // namespace brink
