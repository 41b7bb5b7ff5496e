// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace brink::fuzz {
namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void on_interrupt(int)
{
    interrupted = 1;
    std::signal(SIGINT, SIG_DFL);
}

} // namespace

Progress::Progress(std::uint64_t total) : total_(total), terminal_(isatty(STDERR_FILENO) == 1)
{
    interrupted = 0;
    std::signal(SIGINT, on_interrupt);
}

Progress::~Progress() { std::signal(SIGINT, SIG_DFL); }

bool Progress::stopped() { return interrupted != 0; }

void Progress::print(std::uint64_t done, std::uint64_t findings)
{
    const double seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
    const double rate = seconds > 0 ? static_cast<double>(done) / seconds : 0;
    const double left = rate > 0 ? static_cast<double>(total_ - done) / rate : 0;
    fmt::print(stderr, "{}{} of {} cases, {:.0f} a second, {} findings, {:.0f} s left{}",
               terminal_ ? "\r" : "", done, total_, rate, findings, left, terminal_ ? "\x1b[K" : "\n");
    std::fflush(stderr);
}

void Progress::tell(std::uint64_t done, std::uint64_t findings)
{
    const auto pause = terminal_ ? std::chrono::milliseconds(200) : std::chrono::milliseconds(10'000);
    if (Clock::now() - told_ < pause) return;
    told_ = Clock::now();
    print(done, findings);
}

void Progress::finish(std::uint64_t done, std::uint64_t findings)
{
    print(done, findings);
    if (terminal_) fmt::print(stderr, "\n");
}

} // namespace brink::fuzz
