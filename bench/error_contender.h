// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "error_questions.h"

#include <memory>
#include <string>
#include <vector>

namespace brink::bench {

/// What a contender says of a query.
struct Answer {
    bool contact = false;
    double t = 0;           // of contact; without one it means nothing
    int calls = 0;          // brink: distance evaluations
    bool undecided = false; // brink: neither `hit` nor `separated`; `contact` is set
};

/// One solver at one setting.
class Contender {
public:
    Contender(std::string who, std::string setting) : who_(std::move(who)), setting_(std::move(setting)) {}
    virtual ~Contender() = default;
    Contender(const Contender&) = delete;
    Contender& operator=(const Contender&) = delete;

    const std::string& who() const { return who_; }
    const std::string& setting() const { return setting_; } // "" where there is no choice
    /// The pair is one of the sample that it was made for.
    virtual Answer ask(const Pair&) = 0;

private:
    std::string who_, setting_;
};

using Contenders = std::vector<std::unique_ptr<Contender>>;

/// How a part of the program calls brink.
inline constexpr std::string_view brink_name = "brink";

/// brink at tolerances from 1e-3 to 1e-14. The sample must outlive what is made for it, here and below.
Contenders brink_contenders(const Questions&);

/// FCL 0.7, where it can be asked about the pair: conservative advancement, its default at 10, 100 and 1,000
/// poses, and `collide` at the ends of 1, 10, 100 and 1,000 equal parts of the step.
Contenders fcl_contenders(const Questions&);

/// Bullet's convex casts, where it has the shapes and they the motion. None where Bullet was not found at
/// configure time.
Contenders bullet_contenders(const Questions&);

} // namespace brink::bench
