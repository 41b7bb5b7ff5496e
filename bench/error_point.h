// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace brink::bench {

/// One solver at one tolerance on the hits of one pair: those with a contact in the step that does not graze.
struct ErrorPoint {
    std::string pair;
    std::string who;                   // "brink" or "FCL"
    double tolerance = 0;              // 0: FCL, whose advancement heeds none
    double ns = 0;                     // mean processor time per hit
    double deviation = 0;              // its standard deviation between repetitions, ns
    double p50 = 0, p99 = 0, most = 0; // error of t, in steps, over the hits that the solver saw
    double calls = 0;                  // brink: distance evaluations per hit, mean
    int hits = 0;
    int missed = 0;    // no contact said
    int late = 0;      // contact said at a later time, by more than the truth is in doubt
    int undecided = 0; // brink said neither; its t counts
};

/// A block for every pair, a row for every tolerance.
std::string error_table(const std::vector<ErrorPoint>&);
std::string error_csv(const std::vector<ErrorPoint>&);
/// A gnuplot script, figures included, that draws run time over error, a panel for every pair.
std::string error_plot(const std::vector<ErrorPoint>&);

} // namespace brink::bench
