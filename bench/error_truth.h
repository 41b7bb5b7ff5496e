// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <query.h>
#include <real.h>

#include <string_view>

namespace brink::bench {

/// The bodies of a query that counts as a miss stay farther apart than this (metres): the widest tolerance
/// that anybody is asked for.
inline constexpr double clearance = 1e-3;

enum class Fate : unsigned char {
    contact,  // within the step, and it does not graze
    apart,    // by more than the clearance, throughout
    left_out, // it grazes, passes within the clearance, or nobody knows
};

/// What is so about a query that asks with default options.
struct Truth {
    Fate fate = Fate::left_out;
    support::Real t = 0;     // of first contact
    support::Real doubt = 0; // t is within this
};

/// Whether this build knows the truth about the pair: about all of them where it has the referee.
bool has_truth(const support::Pair&);

/// By long double and brute force where the shapes have no curve but a radius, and are no hulls; else by the
/// referee, which takes a hundred times as long.
Truth truth(const support::Query&);

/// A query with default options that is answered by the referee; left out where the build has none.
Truth refereed_truth(const support::Query&);

/// Who says the truth in this build, in words.
std::string_view truth_teller();

} // namespace brink::bench
