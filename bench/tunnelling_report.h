// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "method.h"

#include <string>
#include <vector>

namespace brink::bench {

/// What one method did with a number of true crossings.
struct Tally {
    int crossings = 0;
    int missed = 0;      // no contact reported in the step
    int late = 0;        // reported, but later than 1e-3 of the step after it happened
    double latest = 0;   // reported - true moment of contact, the most of those reported, steps
    double earliest = 0; // true - reported, likewise
    double ns = 0;       // per query
};

/// One scene and method at one speed (relative distance moved per step over wall thickness).
struct Row {
    const Scene* scene;
    const Method* method;
    double speed;
    Tally tally;
};

/// Over all speeds: counts added, the worst error of all, the mean time.
Tally total(const std::vector<Row>&, const Scene&, const Method&);

/// Percents.
struct Interval {
    double low = 0, high = 0;
};
double percent(int part, int whole);
/// Where the true share lies, with 95 % confidence: E. Wilson's score interval (1927), which holds where
/// nothing was counted too.
Interval confidence(int part, int whole);

std::string tunnelling_csv(const std::vector<Row>&);
/// One row per scene and method: the share missed at each whole decade of speed, and over all speeds.
std::string tunnelling_table(const std::vector<Row>&);

} // namespace brink::bench
