// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "part.h"

#include <string>
#include <string_view>
#include <vector>

namespace brink::bench {

/// What one solver at one setting did with the questions of one pair and kind of motion. Errors are of t, in
/// steps, over the hits that it saw.
struct ErrorPoint {
    std::string pair;
    std::string motion; // "straight" or "turning to 60"
    std::string who, setting;
    double ns = 0;        // processor time per query, see error_measure.h
    double deviation = 0; // its standard deviation between repetitions
    double p50 = not_measured, p99 = not_measured, worst = not_measured;
    double calls = 0; // brink: distance evaluations per query, mean
    int queries = 0;  // whose truth is known, half of them hits
    int hits = 0;
    int missed = 0;     // hits of which no contact was said
    int false_hits = 0; // misses of which contact was said
    int late = 0;       // hits said later than they are
    int undecided = 0;  // brink said neither; its t counts
    int left_out = 0;   // queries drawn that are no part of `queries`

    bool is_brink() const { return who == "brink"; }
    std::string question() const { return pair + " " + motion; }
    /// "brink at 1e-09", "FCL naive, 10 poses".
    std::string name() const;
};

using ErrorPoints = std::vector<ErrorPoint>;

ErrorPoints error_points(const Csv&);
std::string error_csv(const ErrorPoints&);
std::vector<Figure> error_figures(const ErrorPoints&);

/// The points of each question by themselves, in the order in which they come.
std::vector<ErrorPoints> by_question(const ErrorPoints&);

/// A block for every question, a row for every setting of every solver.
std::string error_table(const ErrorPoints&);

} // namespace brink::bench
