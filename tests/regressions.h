// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/print.h"
#include "support/verdict.h"

#if BRINK_HAVE_REFEREE
#include "support/referee.h"
#include "support/referee_turning.h"
#endif

#include <doctest/doctest.h>

#include <algorithm>

namespace brink::tests {

/// Every check that brink-fuzz makes, on one query. Paste what it prints into a test case of
/// regressions_test.cpp, or of regressions_start_test.cpp where it is about the start, or of
/// regressions_apart_test.cpp where that is within rounding of contact, or of
/// regressions_leaving_test.cpp where it is about the way out of contact there, or of
/// regressions_told_test.cpp where only what is told of a contact was wrong.
inline void check(const support::Query& q)
{
    using namespace support;
    Trial trial(q);
    CAPTURE(in_words(trial.toi()));
    const bool referenced = std::max(q.a.index(), q.b.index()) <= 5; // the shapes that the reference knows
    for (const Finding& finding : referenced ? judge(trial) : judge_alone(trial))
        FAIL_CHECK(finding.check, ": ", finding.detail, "\n", as_cpp(q));
#if BRINK_HAVE_REFEREE
    for (const Finding& finding : rule(q, trial.toi()).findings)
        FAIL_CHECK("referee: ", finding.check, ": ", finding.detail, "\n", as_cpp(q));
    if (!refereed(q)) return;
    for (const Finding& finding : verify(q, trial.toi()))
        FAIL_CHECK("in 200 digits: ", finding.check, ": ", finding.detail, "\n", as_cpp(q));
#endif
}

} // namespace brink::tests
