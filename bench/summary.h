// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "part.h"

namespace brink::bench {

/// What a folder of CSVs says of one part.
struct Found {
    std::string part;
    std::vector<Figure> figures;
};

/// Of all parts whose CSV is in the folder. Throws std::invalid_argument, naming file and column, where one
/// does not hold what its part writes.
std::vector<Found> figures_in(const std::filesystem::path& folder);

/// Brink's own figure that a question's rivals are held against: as it is by default.
const Figure* brink_in(const std::vector<Figure>&, std::string_view question);

/// Whether it is one of brink's.
bool is_brink(const Figure&);

/// One solver over all questions of a part that both it and brink were asked.
struct SummaryRow {
    std::string part, who;
    int questions = 0;
    double ns = not_measured;                          // geometric mean
    double times = not_measured;                       // its time over brink's: geometric mean
    double fewest = not_measured, most = not_measured; // likewise, over single questions
    double error = not_measured;                       // median of the questions' medians, in steps
    double worst = not_measured;
    std::int64_t cases = -1, missed = -1, false_hits = -1, wrong = -1, late = -1; // sums, -1: not counted
};

/// Brink first in each part.
std::vector<SummaryRow> summary(const std::vector<Found>&);

/// The cells of a row after part and who, as text, and what stands above them.
std::vector<std::string> cells(const SummaryRow&);
extern const std::vector<std::string> summary_heading;

std::string summary_table(const std::vector<SummaryRow>&);

} // namespace brink::bench
