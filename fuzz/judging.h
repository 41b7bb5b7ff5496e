// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tally.h"
#include "witnesses.h"

#include <string>
#include <vector>

namespace brink::fuzz {

/// Puts one pair's cases on trial before the judges they summon, and before all of them where an answer is
/// suspicious.
Tally tried(const Pair&, std::vector<Case>, Witnesses&);

/// What the judge in doubles said.
std::string in_words(const support::Quick&);

/// Adds `more` to `all`.
void append(support::Findings& all, support::Findings more);

} // namespace brink::fuzz
