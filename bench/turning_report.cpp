// SPDX-License-Identifier: BSD-3-Clause
#include "turning_report.h"

#include <stress_turning.h>

#include <fmt/format.h>
#include <set>

namespace brink::bench {
namespace {

constexpr std::array solvers{Solver::brink, Solver::fcl};

std::string share(const std::vector<double>& values, double part, std::string_view format)
{
    if (values.empty()) return "-";
    const double value = Score::at_share(values, part);
    return fmt::format(fmt::runtime(format), value);
}

std::string row(std::string_view name, const Score& brink, const Score& fcl)
{
    std::string text = fmt::format("{:<22} {:>6} {:>6}", name, brink.cases, brink.meets);
    text += fmt::format(" | {:>5} {:>5} {:>5} {:>5} {:>5} {:>5} {:>5}", brink.wrong, brink.late, brink.broken,
                        brink.undecided, brink.stuck, brink.conservative, brink.unsettled);
    text += fmt::format(" {:>8} {:>8} {:>8} {:>8}", share(brink.steps, 0.5, "{:.1e}"),
                        share(brink.steps, 1, "{:.1e}"), share(brink.used, 0.5, "{:.1g}"),
                        share(brink.used, 1, "{:.3f}"));
    if (fcl.cases == 0) return text + " |      -\n";
    return text + fmt::format(" | {:>6} {:>5} {:>5} {:>5} {:>8} {:>8} {:>8}\n", fcl.cases, fcl.wrong,
                              fcl.late, fcl.undecided, share(fcl.steps, 0.5, "{:.1e}"),
                              share(fcl.steps, 1, "{:.1e}"), share(fcl.used, 1, "{:.1e}"));
}

std::string heading(std::string_view what)
{
    return fmt::format("\n{:<22} {:>6} {:>6} | {:<77} | {}\n", "", "", "", "brink",
                       "FCL conservative advancement") +
           fmt::format(
               "{:<22} {:>6} {:>6} | {:>5} {:>5} {:>5} {:>5} {:>5} {:>5} {:>5} {:>8} {:>8} {:>8} {:>8} "
               "| {:>6} {:>5} {:>5} {:>5} {:>8} {:>8} {:>8}\n",
               what, "cases", "meet", "wrong", "late", "brokn", "undec", "stuck", "cons", "unjud", "p50 dt",
               "max dt", "p50 used", "max used", "asked", "wrong", "late", "hung", "p50 dt", "max dt",
               "max used");
}

constexpr std::string_view legend = R"(
meet: have contact in the step. wrong: contact said where there is none within what is allowed (promise 3 for brink, 1e-4 of
the scale for FCL), or none said where there is one; late: said at a t after it has begun; both by 100 digits. brokn: answers
that break a promise in any way. undec: neither contact nor none is said; stuck: of these, where nothing grazes. cons: a
contact said as not proven (t_upper infinite). unjud: the referee ran out of evaluations. dt: |t - t*| in steps. used: the gap
left at t over what promise 3 allows there, the tolerance mostly (1e-9 where the class does not set it): above 1 is a breach.
FCL is asked where it is trusted with the pair, no gap is to be kept and no body turns by more than 3.1
radians; hung: it crashed, or took more than 100 ms, and is counted as neither. It promises nothing like promise 3, and takes
no tolerance.
)";

} // namespace

Score pooled(const Scores& scores, Solver solver, bool (*belongs)(const Spot&, const Spot&),
             const Spot& wanted)
{
    Score sum;
    for (const auto& [spot, by_solver] : scores.at)
        if (belongs(spot, wanted)) sum.add(by_solver[static_cast<std::size_t>(solver)]);
    return sum;
}

std::string turning_table(const Scores& scores)
{
    std::set<std::size_t> kinds, pairs;
    for (const auto& [spot, unused] : scores.at) {
        kinds.insert(spot.kind);
        pairs.insert(spot.pair);
    }
    const auto add = [&](std::string& text, std::string_view name, auto belongs, const Spot& wanted) {
        text += row(name, pooled(scores, Solver::brink, belongs, wanted),
                    pooled(scores, Solver::fcl, belongs, wanted));
    };
    std::string text = heading("all pairs, by class");
    for (const std::size_t kind : kinds)
        add(text, support::turning_classes[kind].name,
            [](const Spot& s, const Spot& wanted) { return s.kind == wanted.kind; }, {0, kind, 0});
    text += heading("all classes, by pair");
    const std::vector<support::Pair> all = support::all_pairs();
    for (const std::size_t pair : pairs)
        add(text, all[pair].name(), [](const Spot& s, const Spot& wanted) { return s.pair == wanted.pair; },
            {pair, 0, 0});
    add(text, "together", [](const Spot&, const Spot&) { return true; }, {});
    return text + std::string(legend);
}

std::string turning_csv(const Scores& scores)
{
    std::string text =
        "pair,class,level_from,level_to,method,cases,meets,hits,p50_steps,max_steps,p50_ulp,max_ulp,p50_used,"
        "max_used,wrong,late,undecided,stuck,conservative,unsettled,broken\n";
    const std::vector<support::Pair> pairs = support::all_pairs();
    for (const auto& [spot, by_solver] : scores.at) {
        const support::TurningClass& kind = support::turning_classes[spot.kind];
        const double level = kind.first + static_cast<double>(spot.step) * kind.decades;
        for (const Solver solver : solvers) {
            const Score& s = by_solver[static_cast<std::size_t>(solver)];
            if (s.cases == 0) continue;
            text +=
                fmt::format("{},{},{:g},{:g},{},{},{},{},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g},",
                            pairs[spot.pair].name(), kind.name, level, level + kind.decades,
                            solver_names[static_cast<std::size_t>(solver)], s.cases, s.meets, s.steps.size(),
                            Score::at_share(s.steps, 0.5), Score::at_share(s.steps, 1), s.ulp_at(0.5),
                            s.ulp_at(1), Score::at_share(s.used, 0.5), Score::at_share(s.used, 1));
            text += fmt::format("{},{},{},{},{},{},{}\n", s.wrong, s.late, s.undecided, s.stuck,
                                s.conservative, s.unsettled, s.broken);
        }
    }
    return text;
}

} // namespace brink::bench
