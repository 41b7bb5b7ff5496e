// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "real.h"

#include <brink/motion.h>

namespace brink::support {

/// A bounded moving shape in long double, seen from an origin.
class ExactMover {
public:
    ExactMover(const Shape&, const Motion&, const Real3& origin);
    /// The body's point farthest along d at time t.
    Real3 support(const Real3& d, Real t) const;
    Real3 pivot(Real t) const { return from_ + t * by_; }

private:
    const Shape& shape_;
    Real33 axes_;
    Real3 pivot_, from_, by_, axis_;
    Real angle_;
};

} // namespace brink::support
