// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "toi_query.h"

/// First contact under translation with nothing rounded: for the rare query that double arithmetic leaves in
/// doubt. Microseconds for spheres and planes, a tenth of a millisecond for the others; no heap.
namespace brink {

/// What exact arithmetic says of a pair.
struct Verdict {
    /// separated, touching (at t = 0), hit (not touching at 0, contact by t_max); undecided: the numbers
    /// reach over too many powers of two.
    Status status = Status::undecided;
    double t = 0;              // hit: proven apart before t; within 20 ulp of contact
    double t_upper = infinity; // hit: proven in contact by then; at most t_max
};

/// Both shapes translate, valid, of a pair with a closed form, in the table's order.
Verdict exact_contact(const Query& q);

template <class T, class... Ts> constexpr bool is_one_of = (std::is_same_v<T, Ts> || ...);

/// Whether exact numbers can settle what rounding leaves in doubt.
template <class A, class B>
constexpr bool in_whole_numbers = (is_one_of<A, Sphere> && is_one_of<B, Sphere, Capsule, Box, Triangle>) ||
                                  (is_one_of<A, Capsule> && is_one_of<B, Capsule>) ||
                                  (is_one_of<A, Sphere, Capsule, Box, Triangle> &&
                                   is_one_of<B, Plane, HalfSpace>);

} // namespace brink
