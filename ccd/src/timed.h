// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace brink {

/// Adds how long it lasts to a sum of seconds.
class Timed {
public:
    explicit Timed(double& seconds) : seconds_(seconds), began_(Clock::now()) {}
    ~Timed() { seconds_ += std::chrono::duration<double>(Clock::now() - began_).count(); }
    Timed(const Timed&) = delete;
    Timed& operator=(const Timed&) = delete;

private:
    using Clock = std::chrono::steady_clock;
    double& seconds_;
    Clock::time_point began_;
};

} // namespace brink
