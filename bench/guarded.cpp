// SPDX-License-Identifier: BSD-3-Clause
#include "guarded.h"

#include "single_query.h"

#include <benchmark/benchmark.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <new>
#include <span>
#include <stdexcept>
#include <thread>
#include <utility>

namespace brink::bench {
namespace {

using Ending = Said::Ending;

constexpr std::chrono::seconds patience{10};

/// Memory that parent and child share: where the child is, and what it has found.
class Board {
public:
    explicit Board(std::size_t count) : size_(sizeof(Head) + count * sizeof(Said))
    {
        memory_ = mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (memory_ == MAP_FAILED) throw std::runtime_error("no shared memory");
        head_ = new (memory_) Head;
        said_ = {new (static_cast<char*>(memory_) + sizeof(Head)) Said[count], count};
    }
    ~Board() { munmap(memory_, size_); }
    Board(const Board&) = delete;
    Board& operator=(const Board&) = delete;

    std::atomic<std::size_t>& at() { return head_->at; }
    std::span<Said> said() { return said_; }

private:
    struct alignas(64) Head {
        std::atomic<std::size_t> at{0};
    };
    std::size_t size_;
    void* memory_;
    Head* head_;
    std::span<Said> said_;
};

[[noreturn]] void be_child(const std::function<void()>& work)
{
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    work();
    _exit(0);
}

/// Does the work in a child, and says how it ended: if not well, at query board.at().
Ending in_child(Board& board, const std::function<void()>& work)
{
    using Clock = std::chrono::steady_clock;
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no child process");
    if (child == 0) be_child(work);
    std::size_t last = board.at();
    auto moved = Clock::now();
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        if (std::exchange(last, board.at()) != board.at()) moved = Clock::now();
        if (Clock::now() - moved < patience) continue;
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
        return Ending::hung;
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Ending::answered : Ending::crashed;
}

} // namespace

std::vector<Said> ask_guarded(std::size_t count, const std::function<std::optional<double>(std::size_t)>& ask)
{
    Board board(count);
    const std::span<Said> said = board.said();
    for (std::size_t begin = 0; begin < count; begin = board.at() + 1) {
        board.at() = begin;
        const Ending ending = in_child(board, [&] {
            for (; board.at() < count; ++board.at()) {
                const std::optional<double> t = ask(board.at());
                said[board.at()] = {Ending::answered, t.has_value(), t.value_or(0), 0};
            }
        });
        if (ending == Ending::answered) break;
        said[board.at()] = {ending};
    }
    for (;;) {
        std::vector<std::size_t> answered;
        for (std::size_t i = 0; i < count; ++i)
            if (said[i].ending == Ending::answered) answered.push_back(i);
        if (answered.empty()) return {said.begin(), said.end()};
        board.at() = answered.front();
        const Ending ending = in_child(board, [&] {
            const std::vector<double> times = single_query_times(answered.size(), [&](std::size_t k) {
                board.at() = answered[k];
                benchmark::DoNotOptimize(ask(answered[k]));
            });
            for (std::size_t k = 0; k < times.size(); ++k)
                said[answered[k]].ns = times[k];
        });
        if (ending == Ending::answered) return {said.begin(), said.end()};
        said[board.at()] = {ending};
    }
}

} // namespace brink::bench
