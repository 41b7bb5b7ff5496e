// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query.h"

#include <string>

namespace brink::support {

/// The query as a statement that pastes into a test case of tests/regressions*_test.cpp:
/// `check(Query{...});`. Every double in hexadecimal, so that not a bit is lost. `note` becomes a comment
/// above it.
std::string as_cpp(const Query&, std::string_view note = "");

/// One line: status, t, gap and the rest.
std::string in_words(const Toi&);

std::string_view name(Status);

} // namespace brink::support
