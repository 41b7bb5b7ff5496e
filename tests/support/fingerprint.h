// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query.h"

/// Queries and their answers bit by bit, in two numbers: what two builds are compared by.
namespace brink::support {

struct Fingerprint {
    std::uint64_t queries = 0;           // every bit of every query: differs where the generators do
    std::uint64_t answers = 0;           // every bit of every field of every Toi; NaN is one value
    std::array<std::uint64_t, 5> said{}; // how many of each status, in its order
    std::uint64_t turning = 0;           // queries in which something rotates
    std::uint64_t time_only = 0;
    bool same_bits(const Fingerprint& other) const
    {
        return queries == other.queries && answers == other.answers;
    }
};

/// The pairs of the table in turn, each in both orders, one in four with Detail::time_only: as many of each
/// pair, so that 9/55 are of a closed_form() pair (a tenth of which turn), 43/55 of others (half of which
/// turn) and 3/55 are two unbounded bodies.
Query mixed_query(std::uint64_t index);

/// Asks mixed_query(from) to mixed_query(to - 1) in order, going on from an earlier fingerprint.
Fingerprint fingerprint(std::uint64_t from, std::uint64_t to, Fingerprint so_far = {});

/// How far to ask: the program stops at each, the test at the first two.
inline constexpr std::array<std::uint64_t, 3> checkpoints{20'000, 250'000, 1'000'000};

} // namespace brink::support
