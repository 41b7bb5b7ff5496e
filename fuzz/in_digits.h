// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verdict.h"

/// The referee in 200 digits, without its arithmetic; a build without MPFR has none.
namespace brink::fuzz {

/// Whether it is there and can judge the query.
bool verifiable(const support::Query&);

/// What it has against the answer; the checks are named "in 200 digits: ...". Only of what is `verifiable`.
support::Findings verified(const support::Query&, const Toi&);

/// A line: contact, least gap and closing speed as they are.
std::string truth_in_words(const support::Query&);

} // namespace brink::fuzz
