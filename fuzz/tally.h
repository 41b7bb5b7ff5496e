// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace brink::fuzz {

using support::Pair;

/// A way in which another library was wrong, told apart by the reference.
struct Fault {
    std::string cause; // "FCL distance off", ...
    double size = 0;   // length, or time
    std::uint64_t index = 0;
};

/// All the faults of one cause.
struct FaultCount {
    std::uint64_t count = 0;
    double worst = 0;
    std::uint64_t example = 0; // index of the worst
};

/// A disagreement that is brink's, ready to be printed.
struct Complaint {
    std::uint64_t index = 0;
    std::string check, detail, code;
};

/// What happened to one pair. Sums of parts: the order of work does not show.
struct Tally {
    std::uint64_t cases = 0;
    std::array<std::uint64_t, 5> by_status{};
    std::uint64_t refereed = 0, verified = 0, witnessed = 0; // verified: by the referee in 200 digits
    double worst_over = 0;                // gap - target_gap at t for a hit, by the reference: largest
    double worst_under = 0;               // and least
    std::uint64_t given_up = 0;           // by the reference, out of evaluations
    std::uint64_t crashes = 0, hangs = 0; // of the witnesses
    std::map<std::string, FaultCount> faults;
    std::map<std::string, std::uint64_t> complaints_by_check;
    std::vector<Complaint> complaints; // the first `most_printed` of each check
    static constexpr std::uint64_t most_printed = 20;

    void add(const Fault&);
    void add(Complaint);
    void add(const Tally&);
    std::uint64_t brink_findings() const;
};

/// Which judges a pair has, in short: "ref dist CA coll ccd".
std::string judges(const Pair&);

/// The table with a row for each pair, then the faults by cause, then brink's disagreements as C++.
std::string report(const std::vector<Pair>&, const std::vector<Tally>&);

} // namespace brink::fuzz
