// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "error_point.h"

namespace brink::bench {

/// A gnuplot script, figures included: the questions of one kind of motion, a panel each.
std::string error_page(const ErrorPoints&, std::string_view stem, std::string_view headline);

/// One question, large.
std::string error_sheet(const ErrorPoints& of_one_question, std::string_view stem, std::string_view headline);

} // namespace brink::bench
