// SPDX-License-Identifier: BSD-3-Clause
#include "fcl_process.h"

#include "fcl.h"
#include "libccd.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <mutex>
#include <new>
#include <stdexcept>

namespace brink::support {

/// Shared by parent and child: written by one at a time, the pipes say whose turn it is.
struct FclProcess::Bench {
    static constexpr std::size_t seats = 64;
    std::array<Hearing, seats> hearings;
    std::array<Testimony, seats> testimonies;
};

namespace {

/// FCL's motions cannot turn by more than a half turn.
constexpr double widest_turn = 3.1;

bool ask_advancement(const Query& q)
{
    return q.motion_a.rotation.norm() < widest_turn && q.motion_b.rotation.norm() < widest_turn &&
           fcl_trusts(FclQuestion::conservative_advancement, q.a, q.b);
}

bool has_hull(const Hearing& h)
{
    return std::holds_alternative<Hull>(h.query.a) || std::holds_alternative<Hull>(h.query.b);
}

/// One byte each way per question: its seat out, the same back when it is answered.
[[noreturn]] void serve(int line, const Hearing* hearings, Testimony* testimonies)
{
    std::signal(SIGINT, SIG_IGN); // the parent decides when to stop
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO); // FCL prints what it does not support
    dup2(nowhere, STDERR_FILENO);
    const pid_t parent = getppid();
    for (;;) {
        pollfd ready{line, POLLIN, 0};
        if (poll(&ready, 1, 1000) == 0) {
            if (getppid() != parent) _exit(0);
            continue;
        }
        unsigned char seat = 0;
        if (read(line, &seat, 1) != 1) _exit(0);
        testimonies[seat] = testify(hearings[seat]);
        if (write(line, &seat, 1) != 1) _exit(0);
    }
}

} // namespace

Testimony testify(const Hearing& hearing)
{
    const Query& q = hearing.query;
    const FclBody a(q.a);
    const FclBody b(q.b);
    Testimony out;
    for (std::size_t i = 0; i < hearing.count; ++i) {
        const Pose pose_a = q.motion_a.at(hearing.times[i]);
        const Pose pose_b = q.motion_b.at(hearing.times[i]);
        Testimony::At& at = out.at[i];
        if (fcl_trusts(FclQuestion::distance, q.a, q.b)) at.distance = fcl_distance(a, pose_a, b, pose_b);
        if (fcl_trusts(FclQuestion::collide, q.a, q.b)) at.collide = fcl_collide(a, pose_a, b, pose_b);
        if (!libccd_trusts(q.a, q.b)) continue;
        at.gjk = libccd_gjk_overlap(q.a, pose_a, q.b, pose_b);
        at.mpr = libccd_mpr_overlap(q.a, pose_a, q.b, pose_b);
    }
    out.asked_advancement = ask_advancement(q);
    if (out.asked_advancement)
        out.advancement = fcl_continuous(FclQuestion::conservative_advancement, a, q.motion_a, b, q.motion_b);
    out.ending = Ending::answered;
    return out;
}

FclProcess::FclProcess(int patience_ms) : patience_ms_(patience_ms)
{
    void* memory = mmap(nullptr, sizeof(Bench), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::runtime_error("FclProcess: no shared memory");
    bench_ = new (memory) Bench;
    start();
}

FclProcess::~FclProcess()
{
    stop();
    bench_->~Bench();
    munmap(bench_, sizeof(Bench));
}

void FclProcess::start()
{
    // One at a time: a child forked meanwhile would hold this one's end open, and its death would not show.
    static std::mutex forking;
    const std::scoped_lock lock(forking);
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        throw std::runtime_error("FclProcess: no socket");
    child_ = fork();
    if (child_ < 0) throw std::runtime_error("FclProcess: no child");
    if (child_ == 0) {
        close(ends[0]);
        serve(ends[1], bench_->hearings.data(), bench_->testimonies.data());
    }
    close(ends[1]);
    line_ = ends[0];
}

void FclProcess::stop() const
{
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
    close(line_);
}

std::size_t FclProcess::hear_from(std::size_t first, std::size_t count)
{
    for (std::size_t seat = first; seat < count; ++seat) {
        const auto asked = static_cast<unsigned char>(seat);
        if (send(line_, &asked, 1, MSG_NOSIGNAL) != 1) break; // it died: the replies tell at which seat
    }
    for (std::size_t seat = first; seat < count; ++seat) {
        pollfd ready{line_, POLLIN, 0};
        const int polled = poll(&ready, 1, patience_ms_);
        unsigned char answered = 0;
        if (polled == 1 && read(line_, &answered, 1) == 1) continue;
        bench_->testimonies[seat] = Testimony{};
        bench_->testimonies[seat].ending = polled == 0 ? Ending::hung : Ending::crashed;
        ++(polled == 0 ? hangs_ : crashes_);
        return seat;
    }
    return count;
}

std::vector<Testimony> FclProcess::hear(std::span<const Hearing> hearings)
{
    std::vector<Testimony> out;
    for (std::size_t begin = 0; begin < hearings.size(); begin += Bench::seats) {
        const std::size_t count = std::min(Bench::seats, hearings.size() - begin);
        for (std::size_t i = 0; i < count; ++i)
            bench_->hearings[i] = hearings[begin + i];
        // A hull's points are not on the bench but in this process's own memory: a child forked now has them.
        if (std::any_of(hearings.begin() + static_cast<std::ptrdiff_t>(begin),
                        hearings.begin() + static_cast<std::ptrdiff_t>(begin + count), has_hull)) {
            stop();
            start();
        }
        for (std::size_t seat = 0; seat < count;) {
            seat = hear_from(seat, count);
            if (seat == count) break;
            stop();
            start();
            ++seat;
        }
        out.insert(out.end(), bench_->testimonies.begin(),
                   bench_->testimonies.begin() + static_cast<std::ptrdiff_t>(count));
    }
    return out;
}

} // namespace brink::support
