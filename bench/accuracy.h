// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output.h"

#include <string>
#include <vector>

namespace brink::bench {

struct AccuracyOptions {
    int queries = 4000; // of each pair, half of them hits in brink's eyes
    std::vector<std::string> pairs{"all"};
};

/// Names of the pairs that the accuracy of t is measured on.
std::vector<std::string> accuracy_pairs();

/// Run time and error of t of pairs that turn by up to 60 degrees, at tolerances from 1e-3 to 1e-12, against
/// long double and brute force, with FCL's conservative advancement beside it. Table on stdout, accuracy.csv
/// and the picture to `output`. Gives the number of brink's answers that came late or missed a contact.
int run_accuracy(const Output& output, const AccuracyOptions& options);

} // namespace brink::bench
