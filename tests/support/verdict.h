// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "quick_judge.h"
#include "reference.h"

#include <optional>
#include <string>
#include <vector>

namespace brink::support {

/// One way in which an answer breaks a promise of the design.
struct Finding {
    std::string check;            // which promise: "late", "missed a hit", "swap", ...
    std::string detail;           // the figures
    std::optional<Query> asked{}; // where another question than the trial's was answered wrong
};
using Findings = std::vector<Finding>;

/// A query, the answer on trial, and the reference's answer, asked for only when something needs it.
class Trial {
public:
    Trial(Query, Toi);
    explicit Trial(const Query& q) : Trial(q, answer(q)) {}

    const Query& query() const { return query_; }
    const Toi& toi() const { return toi_; }
    const GapOverTime& motion();
    const Reference& referee();
    /// What the judge in doubles says; the query must be judgeable (referee_turning.h).
    const Quick& quick();

    /// 16 eps S: the rounding that design promise 3 allows for.
    Real rounding() { return 16 * 0x1p-52L * motion().scale(); }

    /// What promise 3 allows gap(t) - target_gap to be, without the last bit of t: the rounding where a
    /// closed form decides, else no less than the tolerance.
    Real band();

    /// Whether the start is so near the target gap that rounding decides if there is contact to be ignored.
    bool start_in_doubt();

    /// How far two right answers may lie apart in t: the last bits, and the band over the closing speed.
    Real spread();

private:
    Query query_;
    Toi toi_;
    std::optional<GapOverTime> motion_;
    std::optional<Reference> reference_;
    std::optional<Quick> quick_;
};

/// What shows in the answer alone: status and t in range, unit normal, points consistent.
Findings judge_form(Trial&);

/// What brink's answers to the same question asked otherwise must agree on: time_only, t_max, swapped sides,
/// the world moved rigidly. Two answers that the judge in doubles acquits agree; the reference is asked only
/// about how far apart others may be.
Findings judge_otherwise(Trial&);

/// Both; the second only where the first finds nothing and the answer is not `invalid`.
Findings judge_alone(Trial&);

/// Against the reference: apart before t and not late, touching at t, `separated` really separated, t_upper,
/// contact at the start, gap, normal and points.
Findings judge_by_reference(Trial&);

/// judge_alone() and judge_by_reference().
Findings judge(Trial&);

} // namespace brink::support
