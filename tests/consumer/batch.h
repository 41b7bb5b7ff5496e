// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/ccd.h>

#include <span>

/// First contacts of shape a on each motion with shape b on the motion of the same index; times[i] is NaN
/// unless hit. A library of the stranger's own: always built for the baseline, whatever the flags of the
/// program that calls it.
void first_contacts(const brink::Shape& a, std::span<const brink::Motion> motions_a, const brink::Shape& b,
                    std::span<const brink::Motion> motions_b, std::span<double> times);
