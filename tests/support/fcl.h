// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/ccd.h>

#include <memory>
#include <optional>

/// FCL 0.7 behind one translation unit, in this process: for benchmarks, and for the child process of the
/// oracle. FCL may crash or print on shapes it does not support: ask `fcl_trusts` first (design: which judge
/// each pair has).
namespace brink::support {

/// A prepared FCL geometry (its bounds computed), cheap to copy.
class FclBody {
public:
    explicit FclBody(const Shape&);
    struct Geometry;
    const Geometry& geometry() const { return *geometry_; }

private:
    std::shared_ptr<const Geometry> geometry_;
};

enum class FclQuestion : unsigned char { distance, collide, conservative_advancement, naive };

/// Whether FCL 0.7 can be believed about this question for this pair of shapes.
bool fcl_trusts(FclQuestion, const Shape& a, const Shape& b);

/// Distance by GST_LIBCCD at distance_tolerance 1e-10. Negative when they overlap, by an amount that means
/// nothing.
double fcl_distance(const FclBody& a, const Pose&, const FclBody& b, const Pose&);

bool fcl_collide(const FclBody& a, const Pose&, const FclBody& b, const Pose&);

/// Time of contact by FCL's continuousCollide at its defaults but for the solver: CCDC_NAIVE (FCL's own
/// default, ten poses) or CCDC_CONSERVATIVE_ADVANCEMENT. Empty where FCL reports none, which proves nothing.
std::optional<double> fcl_continuous(FclQuestion solver, const FclBody& a, const Motion&, const FclBody& b,
                                     const Motion&);

/// The same by CCDC_NAIVE with so many poses, from 2 to 10,000: the first at the start of the step and the
/// last at its end.
std::optional<double> fcl_naive(int poses, const FclBody& a, const Motion&, const FclBody& b, const Motion&);

} // namespace brink::support
