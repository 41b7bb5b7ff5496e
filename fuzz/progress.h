// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>

namespace brink::fuzz {

/// Progress on stderr: in place on a terminal, otherwise a line every ten seconds. While it lives, SIGINT
/// only asks to stop; a second one kills.
class Progress {
public:
    explicit Progress(std::uint64_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    static bool stopped();
    void tell(std::uint64_t done, std::uint64_t findings);
    void finish(std::uint64_t done, std::uint64_t findings);

private:
    using Clock = std::chrono::steady_clock;
    void print(std::uint64_t done, std::uint64_t findings);

    std::uint64_t total_;
    bool terminal_;
    Clock::time_point begun_ = Clock::now();
    Clock::time_point told_ = begun_;
};

} // namespace brink::fuzz
