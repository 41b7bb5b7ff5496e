// SPDX-License-Identifier: BSD-3-Clause
#include <brink/overlap.h>

#include "body.h"
#include "exact.h"
#include "tolerance.h"
#include "validity.h"

#include <algorithm>

namespace brink {

namespace {

/// An exact sum of doubles, as an expansion: parts of growing magnitude that do not overlap (J. Shewchuk,
/// Adaptive Precision Floating-Point Arithmetic, 1997). The sign is that of the last part which is not zero.
class ExactSum {
public:
    void add(double x)
    {
        for (int k = 0; k < size_; ++k) {
            const Pair sum = two_sum(x, parts_[k]);
            parts_[k] = sum.lo;
            x = sum.hi;
        }
        parts_[size_++] = x;
    }
    /// The square of an unevaluated sum, times 1 or -1.
    void add_square(Pair p, double sign)
    {
        for (const Pair product :
             {two_product(p.hi, p.hi), two_product(2 * p.hi, p.lo), two_product(p.lo, p.lo)}) {
            add(sign * product.lo);
            add(sign * product.hi);
        }
    }
    [[nodiscard]] bool positive() const
    {
        for (int k = size_ - 1; k >= 0; --k)
            if (parts_[k] != 0) return parts_[k] > 0;
        return false;
    }

private:
    int size_ = 0;
    double parts_[24] = {}; // four squares of six terms
};

/// Whether two balls share a point: the exact answer for the doubles given, as long as no square underflows.
bool balls_overlap(V3 centre_a, double radius_a, V3 centre_b, double radius_b)
{
    // A power of two that keeps squares in range, and the differences from overflowing.
    double largest = std::max(radius_a, radius_b);
    for (const double x : {centre_a.x, centre_a.y, centre_a.z, centre_b.x, centre_b.y, centre_b.z})
        largest = std::max(largest, std::fabs(x));
    int exponent = 0;
    std::frexp(largest, &exponent);
    const auto scaled = [exponent](double x) { return std::ldexp(x, -exponent); };

    const Pair x = two_difference(scaled(centre_b.x), scaled(centre_a.x));
    const Pair y = two_difference(scaled(centre_b.y), scaled(centre_a.y));
    const Pair z = two_difference(scaled(centre_b.z), scaled(centre_a.z));
    const Pair radii = two_sum(scaled(radius_a), scaled(radius_b));
    const double distance = x.hi * x.hi + y.hi * y.hi + z.hi * z.hi, reach = radii.hi * radii.hi;
    if (std::fabs(distance - reach) > tolerance::tight * (distance + reach)) return distance < reach;

    ExactSum difference;
    difference.add_square(x, 1);
    difference.add_square(y, 1);
    difference.add_square(z, 1);
    difference.add_square(radii, -1);
    return !difference.positive();
}

} // namespace

bool overlaps(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b)
{
    if (!valid(a, pose_a) || !valid(b, pose_b)) return true;
    const auto* ball_a = std::get_if<Sphere>(&a);
    const auto* ball_b = std::get_if<Sphere>(&b);
    if (ball_a != nullptr && ball_b != nullptr)
        return balls_overlap(load(pose_a.position), ball_a->radius, load(pose_b.position), ball_b->radius);
    const auto s = separation(a, pose_a, b, pose_b);
    return !s || s->gap <= 0;
}

} // namespace brink
