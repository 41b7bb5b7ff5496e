// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verdict.h"

/// The referees without their arithmetic; a build without MPFR has none.
namespace brink::fuzz {

/// Whether they are there and can judge the query.
bool can_judge(const support::Query&);

/// What the referee has against the answer: proven in long double where that is enough, else in 100 digits.
struct Ruled {
    support::Findings findings;
    bool unsettled = false; // out of evaluations
    bool in_digits = false; // long double was not enough
};
enum class Patience : unsigned char { little, all }; // little: a 40th of the evaluations, for mere doubts
Ruled ruled(const support::Query&, const Toi&, Patience = Patience::all);

/// First contact in 100 digits, beside the answer's.
struct FirstContact {
    bool meets = false;
    bool in_doubt = false;
    bool spent = false;   // out of evaluations
    bool grazes = false;  // contact closes slowly, or there is none by next to nothing
    double early = 0;     // contact less toi.t, in steps
    double least_gap = 0; // the least seen, less the target gap
    double closing_speed = 0;
};
FirstContact first_contact(const support::Query&, const Toi&);

/// What the referee of the closed forms (200 digits, translation only) has against the answer; empty for
/// other queries.
support::Findings verified(const support::Query&, const Toi&);

/// A line or two: contact, least gap and closing speed as they are.
std::string truth_in_words(const support::Query&);

/// Gives back what the digits keep for a thread, at its end.
void forget_digits();

} // namespace brink::fuzz
