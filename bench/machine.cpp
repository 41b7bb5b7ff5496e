// SPDX-License-Identifier: BSD-3-Clause
#include "machine.h"

#include <fmt/format.h>

#include <fstream>
#include <thread>

namespace brink::bench {
namespace {

std::string processor()
{
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown processor";
}

std::string compiler()
{
#ifdef __clang__
    return fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
    return fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

} // namespace

std::string machine()
{
    return fmt::format("{}, {} cores\n{} {}; brink {}, FCL {}", processor(),
                       std::thread::hardware_concurrency(), compiler(), BRINK_BENCH_FLAGS,
                       BRINK_BENCH_VERSION, BRINK_BENCH_FCL_VERSION);
}

std::string build_name() { return BRINK_BENCH_BUILD; }

bool runs_v3()
{
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2");
#else
    return false;
#endif
}

} // namespace brink::bench
