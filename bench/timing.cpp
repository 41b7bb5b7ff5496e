// SPDX-License-Identifier: BSD-3-Clause
#include "timing.h"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

namespace brink::bench {

const Timing* find(const std::vector<Timing>& timings, std::string_view pair, std::string_view turning,
                   std::string_view who, std::string_view what)
{
    const auto found = std::find_if(timings.begin(), timings.end(), [&](const Timing& t) {
        return t.pair == pair && t.turning == turning && t.who == who && t.what == what;
    });
    return found == timings.end() ? nullptr : &*found;
}

std::string timings_csv(const std::vector<Timing>& timings)
{
    std::string text = "pair,turning,who,what,ns_per_query,standard_deviation_ns,p50_ns,p99_ns,calls_mean,"
                       "calls_max,undecided,queries,repetitions\n";
    for (const Timing& t : timings)
        text += fmt::format("{},{},{},{},{:.2f},{:.2f},{:.0f},{:.0f},{:.3f},{},{},{},{}\n", t.pair, t.turning,
                            t.who, t.what, t.ns, t.deviation, t.p50, t.p99, t.calls, t.most_calls,
                            t.undecided, t.queries, t.repetitions);
    return text;
}

std::vector<Timing> parse_timings(std::string_view csv)
{
    std::vector<Timing> timings;
    std::istringstream lines{std::string(csv)};
    for (std::string line; std::getline(lines, line);) {
        Timing t;
        std::istringstream cells(line);
        for (std::string* name : {&t.pair, &t.turning, &t.who, &t.what})
            std::getline(cells, *name, ',');
        char comma = 0;
        cells >> t.ns >> comma >> t.deviation >> comma >> t.p50 >> comma >> t.p99 >> comma >> t.calls;
        cells >> comma >> t.most_calls >> comma >> t.undecided >> comma >> t.queries >> comma;
        if (cells >> t.repetitions) timings.push_back(t);
    }
    return timings;
}

} // namespace brink::bench
