// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query_text.h"
#include "tally.h"

#include <fstream>
#include <string>
#include <vector>

namespace brink::fuzz {

/// The queries of all complaints, each with what it was found guilty of.
std::vector<support::KeptQuery> queries_of(const std::vector<Pair>&, const std::vector<Tally>&);

/// A file to keep queries in (query_text.h), or none where no name is given. Opened at once: the constructor
/// throws std::runtime_error, naming the file, where it cannot be written, before a long campaign is run.
class Keep {
public:
    explicit Keep(std::string file);
    void write(const std::vector<support::KeptQuery>&);

private:
    std::string file_;
    std::ofstream out_;
};

} // namespace brink::fuzz
