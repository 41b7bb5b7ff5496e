// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tally.h"
#include "verdict.h"

#include <memory>
#include <span>

namespace brink::fuzz {

/// Who judges a case even where brink's answer is not suspicious.
struct Summons {
    bool reference_knows = true; // else the dense reference is not asked at all
    bool reference = true;
    bool referee = true;
    bool digits = true; // the contact in 100 digits, that of a closed form in 200 too
    bool witnesses = true;
    bool otherwise = true; // brink itself, asked the same in other ways
    bool valid = true;     // else the answer `invalid` is taken as right
};

/// A trial and where it came from.
struct Case {
    std::uint64_t index = 0;
    support::Trial trial;
    Summons summons;
    bool sworn = false; // its contact has been found in digits
};

/// What FCL and libccd had to say against an answer, judged by the reference.
struct Statement {
    support::Findings against_brink;
    std::vector<Fault> against_them;
    bool crashed = false;
    bool hung = false;
};

/// FCL and libccd in a child process of their own. Without FCL in the build they have nothing to say.
class Witnesses {
public:
    Witnesses();
    ~Witnesses();
    std::vector<Statement> question(std::span<Case>);
    /// Whether they were asked at all.
    static bool present();

private:
    struct Process;
    std::unique_ptr<Process> process_;
};

} // namespace brink::fuzz
