// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query.h"

#include <sys/types.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

/// FCL and libccd in a child process: they may crash or hang, and that must cost one answer and not the
/// campaign.
namespace brink::support {

/// One question to the judges: the query's shapes at up to twelve times, and FCL's conservative advancement.
struct Hearing {
    static constexpr std::size_t most_times = 12;
    Query query;
    std::array<double, most_times> times{};
    std::size_t count = 0;
};

enum class Ending : unsigned char { pending, answered, crashed, hung };

/// What they said. Where a judge cannot be trusted with the pair (fcl_trusts, libccd_trusts) its vote is
/// absent.
struct Testimony {
    struct At {
        std::optional<double> distance; // FCL
        std::optional<bool> collide;    // FCL
        std::optional<bool> gjk, mpr;   // libccd
    };
    Ending ending = Ending::pending;
    std::array<At, Hearing::most_times> at;
    bool asked_advancement = false;
    std::optional<double> advancement; // FCL's conservative advancement: absent where it reports no contact
};

/// Owns the child. Not to be shared between threads.
class FclProcess {
public:
    /// `patience_ms`: how long one answer may take before the child is taken to hang.
    explicit FclProcess(int patience_ms = 3000);
    ~FclProcess();
    FclProcess(const FclProcess&) = delete;
    FclProcess& operator=(const FclProcess&) = delete;

    /// Answers in the order asked. A child that died or hung is replaced and goes on after the culprit.
    std::vector<Testimony> hear(std::span<const Hearing>);

    int crashes() const { return crashes_; }
    int hangs() const { return hangs_; }

private:
    struct Bench;
    void start();
    void stop() const;
    /// Hears bench entries from `first` to `count`; returns the first unanswered.
    std::size_t hear_from(std::size_t first, std::size_t count);

    int patience_ms_;
    Bench* bench_ = nullptr; // shared memory
    pid_t child_ = -1;
    int line_ = -1; // a socket to the child
    int crashes_ = 0;
    int hangs_ = 0;
};

/// What the child does with one question, in the process that calls it.
Testimony testify(const Hearing&);

} // namespace brink::support
