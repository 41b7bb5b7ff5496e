// SPDX-License-Identifier: BSD-3-Clause
#include "support/fingerprint.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace brink;
using namespace brink::support;

namespace {

/// What fingerprint() finds at the first checkpoints. `build/tests/brink-determinism` prints them.
constexpr std::array<std::uint64_t, 2> golden_queries{0xfa3a135a0beb2ab2, 0xde2850f50c2fc361};
constexpr std::array<std::uint64_t, 2> golden_answers{0xdfaff59436a67824, 0x2722857dc92f39};

/// Under sanitizers the second takes minutes.
#ifdef NDEBUG
constexpr std::size_t asked = golden_answers.size();
#else
constexpr std::size_t asked = 1;
#endif

} // namespace

TEST_CASE("the same bits as ever: mixed queries")
{
    Fingerprint found;
    std::array<std::uint64_t, 2> queries{};
    std::array<std::uint64_t, 2> answers{};
    for (std::size_t i = 0; i < asked; ++i) {
        found = fingerprint(i == 0 ? 0 : checkpoints[i - 1], checkpoints[i], found);
        queries[i] = found.queries;
        answers[i] = found.answers;
    }
    const auto as_line = [](std::string_view name, const std::array<std::uint64_t, 2>& values) {
        return fmt::format("constexpr std::array<std::uint64_t, 2> {}{{{:#x}, {:#x}}};", name, values[0],
                           values[1]);
    };
    const std::uint64_t total = checkpoints[asked - 1];
    CHECK(found.said[static_cast<std::size_t>(Status::hit)] > total / 4);
    CHECK(found.said[static_cast<std::size_t>(Status::separated)] > total / 5);
    CHECK(found.said[static_cast<std::size_t>(Status::touching)] > total / 50);
    CHECK(found.turning > total / 5);
    CHECK(found.time_only > total / 5);
    for (std::size_t i = 0; i < asked; ++i) {
        INFO("The generators draw other queries than they did. If they are meant to, put into this file, "
             "from a Release build:\n",
             as_line("golden_queries", queries));
        CHECK(queries[i] == golden_queries[i]);
    }
    for (std::size_t i = 0; i < asked; ++i) {
        INFO("Answers have changed in some bit. If they are meant to, put into this file, from a Release "
             "build:\n",
             as_line("golden_answers", answers));
        CHECK(answers[i] == golden_answers[i]);
    }
}

TEST_CASE("the same bits: a fingerprint goes on where it stopped, and sees every query")
{
    const Fingerprint whole = fingerprint(0, 2000);
    CHECK(fingerprint(700, 2000, fingerprint(0, 700)).same_bits(whole));
    CHECK(fingerprint(0, 1999).queries != whole.queries);
    CHECK(fingerprint(1, 2000).answers != whole.answers);
}
