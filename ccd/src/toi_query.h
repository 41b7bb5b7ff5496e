// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/toi.h>

#include <limits>

namespace brink {

/// What time_of_impact was asked, by reference.
struct Query {
    const Shape& a;
    const Motion& motion_a;
    const Shape& b;
    const Motion& motion_b;
    const Options& options;
    const Query* given = this; // the same in the caller's own lengths
};

/// An answer that has a time but no contact to tell about.
static inline Toi plain(Status status, double t, double t_upper = infinity)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {status, t, t_upper, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, nan, 0};
}

/// Swaps the sides of an answer.
static inline Toi flipped(Toi toi)
{
    const Vec3 point_a = toi.point_a;
    toi.point_a = toi.point_b;
    toi.point_b = point_a;
    for (int i = 0; i < 3; ++i)
        toi.normal.data()[i] = 0 - toi.normal.data()[i]; // never -0
    return toi;
}

/// How the table decides a pair.
enum class Method : unsigned char {
    closed_form, // where nothing rotates; what it leaves in doubt is asked in whole numbers
    direct,      // where nothing rotates; what it leaves in doubt goes to advancement
    advancement,
    none
};
Method method(const Shape& a, const Shape& b);

} // namespace brink
