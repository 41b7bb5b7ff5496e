// SPDX-License-Identifier: BSD-3-Clause
#include "pairs_report.h"

#include "output.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

namespace brink::bench {
namespace {

std::optional<double> mean(const Timing* timing)
{
    return timing != nullptr ? std::optional(timing->ns) : std::nullopt;
}

const Timing* first_of(const std::vector<Timing>& timings, Turning turning)
{
    const auto found = std::find_if(timings.begin(), timings.end(),
                                    [&](const Timing& t) { return t.turning == name_of(turning); });
    return found == timings.end() ? nullptr : &*found;
}

std::string cell(std::optional<double> ns)
{
    return ns ? fmt::format("{:.{}f}", *ns, *ns < 100 ? 1 : 0) : "-";
}

std::string ratio(std::optional<double> theirs, std::optional<double> ours)
{
    if (!theirs || !ours) return "-";
    const double times = *theirs / *ours;
    return fmt::format("{:.{}f} x", times, times < 9.95 ? 1 : 0);
}

double worst_deviation(const std::vector<Timing>& timings, Turning turning)
{
    double worst = 0;
    for (const Timing& t : timings)
        if (t.turning == name_of(turning)) worst = std::max(worst, 100 * t.deviation / t.ns);
    return worst;
}

int undecided(const std::vector<Timing>& timings, Turning turning)
{
    int count = 0;
    for (const Timing& t : timings)
        if (t.turning == name_of(turning) && t.who == "baseline" && t.what != "mixed") count += t.undecided;
    return count;
}

constexpr std::string_view spread_heading = " mixed    +-    p50    p99   hits misses";

std::string spread_cells(const Timing* mixed, const Timing* hits, const Timing* misses)
{
    if (mixed == nullptr || hits == nullptr || misses == nullptr)
        return fmt::format("{:>6} {:>5} {:>6} {:>6} {:>6} {:>6}", "-", "-", "-", "-", "-", "-");
    return fmt::format("{:>6.0f} {:>5.0f} {:>6.0f} {:>6.0f} {:>6.0f} {:>6.0f}", mixed->ns, mixed->deviation,
                       mixed->p50, mixed->p99, hits->ns, misses->ns);
}

std::string turning_legend(const std::vector<Timing>& timings, Turning turning, const Timing& first)
{
    std::string text = fmt::format(
        "{} distinct pairs of 2,048 bodies, half of them hits (mixed), axes and angles at random. mixed, "
        "hits, "
        "misses: mean\nprocessor time over {} repetitions, +- its standard deviation between them. p50, p99: "
        "mixed queries one by one between\ntwo readings of the steady clock, the middle of three, less the "
        "clock's own time in the same run. calls, most: distance\nevaluations per hit, mean and maximum. "
        "Undecided: {} of all queries.\n",
        thousands(first.queries), first.repetitions, undecided(timings, turning));
    if (turning == Turning::to_300_degrees) return text + "FCL's motions cannot turn beyond 180 degrees.\n";
    return text + "FCL: 4,096 of the pairs; -: its conservative advancement does not answer the pair.\n";
}

} // namespace

std::string translation_table(const std::vector<Timing>& timings)
{
    const Timing* first = first_of(timings, Turning::none);
    if (first == nullptr) return "";
    std::string text =
        "One query through time_of_impact, ns: mean processor time, contact detail unless time_only.\n";
    text += fmt::format("{:<19} | {:^31} | {:^31} | {:^25}\n", "nothing rotates", "brink, baseline x86-64",
                        "brink, x86-64-v3", "FCL advancement");
    text += fmt::format("{:<19} |", "");
    for (int build = 0; build < 2; ++build)
        text += fmt::format(" {:>6} {:>6} {:>6} {:>10} |", "mixed", "hits", "misses", "time_only");
    text += fmt::format(" {:>6} {:>9} {:>8}\n", "mixed", "/baseline", "/v3");
    for (const PairKind& kind : pairs_turning(Turning::none)) {
        const auto get = [&](std::string_view who, std::string_view what) {
            return mean(find(timings, kind.name, name_of(Turning::none), who, what));
        };
        if (!get("baseline", "mixed")) continue;
        text += fmt::format("{:<19} |", kind.name);
        for (const char* build : {"baseline", "x86-64-v3"})
            text += fmt::format(" {:>6} {:>6} {:>6} {:>10} |", cell(get(build, "mixed")),
                                cell(get(build, "hits")), cell(get(build, "misses")),
                                cell(get(build, "mixed time_only")));
        const auto fcl = get("FCL", "mixed");
        text += fmt::format(" {:>6} {:>9} {:>8}\n", cell(fcl), ratio(fcl, get("baseline", "mixed")),
                            ratio(fcl, get("x86-64-v3", "mixed")));
    }
    return text + fmt::format("{} distinct pairs of 2,048 bodies, {} repetitions (FCL: 4,096 pairs); mixed: "
                              "half hit. Largest deviation between repetitions {:.0f} %.\n"
                              "-: FCL's conservative advancement does not answer this pair.\n",
                              thousands(first->queries), first->repetitions,
                              worst_deviation(timings, Turning::none));
}

std::string turning_table(const std::vector<Timing>& timings, Turning turning)
{
    const Timing* first = first_of(timings, turning);
    if (first == nullptr) return "";
    std::string text =
        fmt::format("Both bodies turn by up to {} degrees, ns per query, tolerance 1e-9\n", name_of(turning));
    text += fmt::format("{:<19} | {:^58} | {:^45} | {:^32}\n", "", "brink, baseline x86-64",
                        "brink, x86-64-v3", "FCL advancement");
    text += fmt::format("{:<19} | {} {:>5} {:>6} | {} | {:>6} {:>6} {:>6} {:>9}\n", "", spread_heading,
                        "calls", "most", spread_heading, "mixed", "p50", "p99", "/baseline");
    for (const PairKind& kind : pairs_turning(turning)) {
        const auto get = [&](std::string_view who, std::string_view what) {
            return find(timings, kind.name, name_of(turning), who, what);
        };
        const Timing* mixed = get("baseline", "mixed");
        const Timing* hits = get("baseline", "hits");
        const Timing* fcl = get("FCL", "mixed");
        if (mixed == nullptr || hits == nullptr) continue;
        text += fmt::format(
            "{:<19} | {} {:>5.2f} {:>6} | {} |", kind.name,
            spread_cells(mixed, hits, get("baseline", "misses")), hits->calls, hits->most_calls,
            spread_cells(get("x86-64-v3", "mixed"), get("x86-64-v3", "hits"), get("x86-64-v3", "misses")));
        text += fcl == nullptr ? fmt::format(" {:>6} {:>6} {:>6} {:>9}\n", "-", "-", "-", "-")
                               : fmt::format(" {:>6.0f} {:>6.0f} {:>6.0f} {:>9}\n", fcl->ns, fcl->p50,
                                             fcl->p99, ratio(fcl->ns, mixed->ns));
    }
    return text + turning_legend(timings, turning, *first);
}

} // namespace brink::bench
