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

/// Whether this build knows the truth about the pair: all of them where it has the referee.
bool has_truth(const support::Pair&);

Truth truth(const support::Query&);

/// "the referee, to 100 digits", or whoever else says the truth.
std::string_view truth_teller();

} // namespace brink::bench
