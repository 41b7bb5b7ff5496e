// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pair_sample.h"

#include <real.h>

namespace brink::bench {

/// What is known of a query by long double and brute force, without brink.
struct Truth {
    bool contact = false;
    bool grazing = false;    // closing speed at contact below 1e-3 of the fastest relative motion
    bool known = true;       // false where the search was given up
    support::Real t = 1;     // first contact
    support::Real doubt = 0; // t is within this
};

/// Two hulls, or two shapes that support::reference knows, apart at the start.
Truth truth(const Body& a, const Body& b);

} // namespace brink::bench
