// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "replay_answers.h"

#include <string>

namespace brink::bench {

/// What a method said to some of the queries.
struct ReplayScore {
    int asked = 0, crashed = 0, hung = 0;
    int true_contacts = 0, missed = 0, false_contacts = 0; // of those whose fact is known
    int late = 0;                                          // by more than `lateness`
    double latest = 0;                                     // steps; 0 where nothing is late at all
    /// |t - contact|, in steps, of the contacts found that were none at the start: shares of, and the worst.
    double error_p50 = 0, error_p99 = 0, error_most = 0;
    double mean = 0, p50 = 0, p99 = 0, most = 0; // ns
};

/// An answer later than that counts as late, steps.
inline constexpr double replay_lateness = 1e-6;

ReplayScore replay_score(const ReplayAnswers&, std::size_t method, const std::vector<std::size_t>& queries);

/// A part of the queries.
struct ReplayGroup {
    std::string name; // in the CSV
    std::vector<std::size_t> queries;
};
/// all; those that every method answered, called common; these by outcome; and by pair.
std::vector<ReplayGroup> replay_groups(const ReplayAnswers&);

std::string replay_tables(const ReplayAnswers&);
std::string replay_csv(const ReplayAnswers&);
/// A gnuplot script, figures included, to replay.svg and .png.
std::string replay_plot(const ReplayAnswers&);

} // namespace brink::bench
