// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
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

/// The check that an undecided answer fails where nothing grazes. It is safe and breaks no promise, so it is
/// printed and counted, but not among the disagreements.
inline constexpr std::string_view guilty = "undecided, not grazing";

/// A disagreement that is brink's, ready to be printed.
struct Complaint {
    std::uint64_t index = 0;
    std::string check, detail;
    support::Query asked;
    std::string note; // what brink answered, or how it was asked otherwise
};

/// What happened to one pair. Sums of parts: the order of work does not show.
struct Tally {
    std::uint64_t cases = 0;
    std::array<std::uint64_t, 5> by_status{};
    std::uint64_t quick = 0, strict = 0, unproven = 0; // by the judge in doubles: cases, those acquitted of
                                                       // everything, and those not acquitted
    std::uint64_t asked = 0;                           // of brink in other ways
    std::uint64_t ruled = 0, in_digits = 0, unsettled = 0; // by the referee: cases, those that took digits,
                                                           // and those in which it ran out of evaluations
    std::uint64_t sworn = 0, in_doubt = 0; // whose contact was found in digits; decided by less than 1e-40
    std::uint64_t excused = 0;             // undecided, and grazing
    std::uint64_t referenced = 0, given_up = 0; // by the reference; out of evaluations
    std::uint64_t witnessed = 0;
    std::uint64_t evaluations = 0; // Toi::iterations of all, and of the hits that were advanced
    std::uint64_t advanced_hits = 0, hit_evaluations = 0, most_evaluations = 0;
    std::uint64_t crashes = 0, hangs = 0; // of the witnesses
    std::map<std::string, FaultCount> faults;
    std::map<std::string, std::uint64_t> complaints_by_check;
    std::vector<Complaint> complaints; // the first `most_printed` of each check
    static constexpr std::uint64_t most_printed = 20;
    /// How early hits were that do not graze, in steps, by tolerance: 0, to 1e-12, 1e-9, 1e-6, above.
    static constexpr std::array<double, 4> tolerances{0, 1e-12, 1e-9, 1e-6};
    std::array<std::vector<double>, tolerances.size() + 1> early;

    void add_early(double tolerance, double steps);
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
