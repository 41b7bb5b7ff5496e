// SPDX-License-Identifier: BSD-3-Clause
#include "error_point.h"

#include <fmt/format.h>

namespace brink::bench {
namespace {

constexpr std::string_view legend = R"(
ns: mean processor time per query over up to 4,096 of them, half hits and half misses, the same for all solvers: the middle
one of the repetitions, +- their standard deviation. p50, p99, max: error of t, in steps, over the hits seen. calls: distance
evaluations per query. miss: of the hits, no contact said. false: of the misses, whose bodies stay 1 mm apart, contact
said. late: said after contact (a rival's by more than 1e-6 of the step, which forgives floats their rounding). undec:
neither said. Left out: queries that graze (closing at less than 1e-3 of the fastest motion, or passing within 1 mm).
Every number of a query is a float. FCL's conservative advancement heeds no tolerance. Bullet computes in floats; its
casts have margins of 1 um, and where a body turns by more than 45 degrees, more than it can, are asked about the two
halves of the step; its two advancements end within 1 mm by their own choice.
)";

} // namespace

std::string error_table(const ErrorPoints& points)
{
    std::string text = "Run time and error of t\n";
    for (const ErrorPoints& question : by_question(points)) {
        const ErrorPoint& first = question.front();
        text += fmt::format("\n{}: {} hits, {} misses, {} left out\n", first.question(), first.hits,
                            first.queries - first.hits, first.left_out);
        text += fmt::format("  {:<42} {:>9} {:>7} | {:>8} {:>8} {:>8} | {:>5} | {:>5} {:>5} {:>5} {:>5}\n",
                            "", "ns", "+-", "p50", "p99", "max", "calls", "miss", "false", "late", "undec");
        for (const ErrorPoint& p : question)
            text += fmt::format(
                "  {:<42} {:>9.0f} {:>7.0f} | {:>8.1e} {:>8.1e} {:>8.1e} | {:>5} | {:>5} {:>5} {:>5} {:>5}\n",
                p.name(), p.ns, p.deviation, p.p50, p.p99, p.worst,
                p.is_brink() ? fmt::format("{:.2f}", p.calls) : "-", p.missed, p.false_hits, p.late,
                p.is_brink() ? fmt::format("{}", p.undecided) : "-");
    }
    return text + std::string(legend);
}

} // namespace brink::bench
