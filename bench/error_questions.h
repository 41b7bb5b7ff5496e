// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "error_truth.h"
#include "pair_sample.h"

#include <string>
#include <vector>

namespace brink::bench {

/// A query of which the truth is known, and counts.
struct Judged {
    Pair pair;
    Truth truth;
};

/// What is asked about one pair of shapes in one kind of motion. Every number in it is a float, so that
/// rivals that compute in floats answer the same questions.
struct Questions {
    std::string pair;
    Turning turning;
    Sample sample;
    std::vector<Judged> judged; // as many hits as misses
    int left_out = 0;           // of those looked at for `judged`: neither hit nor miss

    const Shape& first_shape() const { return sample.bodies.front().shape; }
    const Shape& second_shape() const { return sample.bodies.back().shape; }
};

/// `judged` queries, or as many as `timed` gives. `timed`: queries in Sample::mixed.
struct Wanted {
    int judged, timed;
};

/// With default options.
support::Query query(const Sample&, const Pair&);

Questions draw_questions(const support::Pair&, Turning, const Wanted&);

} // namespace brink::bench
