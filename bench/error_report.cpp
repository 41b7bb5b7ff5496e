// SPDX-License-Identifier: BSD-3-Clause
#include "error_point.h"

#include <fmt/format.h>

namespace brink::bench {
namespace {

constexpr std::string_view legend = R"(
hits: queries with a contact that does not graze (closing at 1e-3 of the fastest motion or more), which is known by long
double and brute force. ns: mean processor time of a hit, +- its standard deviation between 15 repetitions. p50, p99, max:
error of t, in steps. calls: distance evaluations. missed: no contact said. late: said after contact. undec: neither said.
FCL's conservative advancement ignores the tolerance that it is given: it has one row.
)";

} // namespace

std::string error_table(const std::vector<ErrorPoint>& points)
{
    std::string text = "Run time and error of t, both bodies turning by up to 60 degrees\n";
    text += fmt::format(
        "{:<16} {:<6} {:>9} {:>6} | {:>7} {:>5} | {:>8} {:>8} {:>8} | {:>5} | {:>6} {:>5} {:>5}\n", "pair",
        "solver", "tolerance", "hits", "ns", "+-", "p50", "p99", "max", "calls", "missed", "late", "undec");
    std::string_view last;
    for (const ErrorPoint& p : points) {
        const bool brink = p.who == "brink";
        text += fmt::format(
            "{:<16} {:<6} {:>9} {:>6} | {:>7.0f} {:>5.0f} | {:>8.1e} {:>8.1e} {:>8.1e} | {:>5} | "
            "{:>6} {:>5} {:>5}\n",
            p.pair == last ? "" : p.pair, p.who, brink ? fmt::format("{:.0e}", p.tolerance) : "-", p.hits,
            p.ns, p.deviation, p.p50, p.p99, p.most, brink ? fmt::format("{:.2f}", p.calls) : "-", p.missed,
            p.late, brink ? fmt::format("{}", p.undecided) : "-");
        last = p.pair;
    }
    return text + std::string(legend.substr(1));
}

std::string error_csv(const std::vector<ErrorPoint>& points)
{
    std::string text =
        "pair,who,tolerance,hits,ns_per_hit,standard_deviation_ns,p50_error,p99_error,max_error,"
        "calls_mean,missed,late,undecided\n";
    for (const ErrorPoint& p : points)
        text += fmt::format("{},{},{:g},{},{:.2f},{:.2f},{:.3e},{:.3e},{:.3e},{:.3f},{},{},{}\n", p.pair,
                            p.who, p.tolerance, p.hits, p.ns, p.deviation, p.p50, p.p99, p.most, p.calls,
                            p.missed, p.late, p.undecided);
    return text;
}

} // namespace brink::bench
