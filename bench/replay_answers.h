// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "guarded.h"

#include <query_text.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace brink::bench {

/// What is so about a query, found by the referee.
struct Fact {
    enum class Outcome : unsigned char {
        unknown, // no referee, not valid, or it could not tell
        starts,  // in contact at the start
        meets,   // later
        apart,
    };
    Outcome outcome = Outcome::unknown;
    double t = 0; // of first contact
};

/// The methods that are asked, brink first.
inline constexpr std::array<std::string_view, 3> replay_methods{"brink", "FCL conservative advancement",
                                                                "FCL default"};
/// How they are called in the CSV.
inline constexpr std::array<std::string_view, 3> replay_columns{"brink", "fcl_advancement", "fcl_default"};

struct ReplayAnswers {
    std::string file; // that the queries come from
    std::vector<support::KeptQuery> queries;
    std::vector<Fact> facts;               // of each query
    std::vector<Toi> brink;                // to each
    std::array<std::vector<Said>, 3> said; // by each method, to each query; `unasked` what it does not know
    std::vector<std::string> objections;   // of the referee against brink, each with file, line and figures
    bool refereed = false;                 // there is a referee in this build
    std::size_t pair(std::size_t query) const; // the place of a query's pair in support::all_pairs()
};

/// Whether there is a referee in this build.
bool has_referee();
/// The referee's word on a query.
Fact fact_of(const support::Query&);
/// What it has against the answer: promises broken, and `undecided` where nothing grazes; with figures.
std::vector<std::string> objections_to(const support::Query&, const Toi&);

/// Reads the file and asks everybody everything. Throws std::runtime_error where it cannot be read.
ReplayAnswers ask_all(const std::string& file);

} // namespace brink::bench
