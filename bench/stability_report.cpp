// SPDX-License-Identifier: BSD-3-Clause
#include "stability_report.h"

#include "stability_case.h"

#include <stress.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace brink::bench {
namespace {

constexpr double most = 0.999; // the share of hits that "p99.9" speaks of

/// Five characters at most: 0.53, 12, 3e15.
std::string figure(double x)
{
    if (!std::isfinite(x)) return "inf";
    if (x == 0) return "0";
    if (x < 0.01) return "<0.01";
    if (x < 10) return fmt::format("{:.2g}", x);
    if (x < 9999.5) return fmt::format("{:.0f}", x);
    const int exponent = static_cast<int>(std::floor(std::log10(x) + 0.022)); // 9.5e3 and more is 1e4
    return fmt::format("{:.0f}e{}", x / std::pow(10, exponent), exponent);
}

std::string error_cells(const Score& score)
{
    if (score.ulps.empty()) return fmt::format("{:>5} {:>5} {:>5}", "-", "-", "-");
    return fmt::format("{:>5} {:>5} {:>5}", figure(score.ulp_at(most)), figure(score.ulp_at(1)),
                       figure(score.backward));
}

std::string cells(const Score& score)
{
    if (score.cases == 0) return fmt::format("{:>29}", "");
    return fmt::format("{} {:>5} {:>5}", error_cells(score), score.wrong, score.late);
}

std::string heading(const support::Pair& pair, bool centres)
{
    std::string text =
        fmt::format("\n{:<18} {:>5} {:>5} | {:<{}} | {:<29} | {:<29} | {}\n", pair.name(), "", "", "brink",
                    centres ? 59 : 53, "textbook root", "stable root", "FCL conservative advancement");
    const auto common = fmt::format("{:>5} {:>5} {:>5} {:>5} {:>5}", "p99.9", "max", "back", "wrong", "late");
    return text + fmt::format("{:<18} {:>5} {:>5} | {}{} {:>5} {:>5} {:>5} {:>5} | {} | {} | {:>5} {}\n", "",
                              "cases", "hits", common, centres ? "  /C+R" : "", "undec", "cons", "brckt",
                              "brokn", common, common, "asked", common);
}

void add_row(std::string& text, const Scores& scores, std::size_t pair, std::size_t kind, bool centres)
{
    const auto total = [&](Solver solver) { return scores.total(pair, kind, solver); };
    const Score brink = total(Solver::brink);
    const Score fcl = total(Solver::fcl);
    text += fmt::format("{:<18} {:>5} {:>5} | {}", support::stress_classes[kind].name, brink.cases,
                        brink.ulps.size(), cells(brink));
    if (centres) text += fmt::format(" {:>5}", brink.ulps.empty() ? "-" : figure(brink.backward_centres));
    text += fmt::format(" {:>5} {:>5} {:>5} {:>5}", brink.undecided, brink.conservative,
                        figure(brink.bracket), brink.broken);
    text += fmt::format(" | {} | {}", cells(total(Solver::textbook)), cells(total(Solver::stable)));
    text += fcl.cases == 0 ? " |     -\n" : fmt::format(" | {:>5} {}\n", fcl.cases, cells(fcl));
}

constexpr std::string_view legend = R"(
hits: contact in (0, t_max] that brink and both formulas see; errors are over these, FCL's over those of them it was asked.
p99.9, max: |t - t*| in units in the last place of t*; t* by 200 digits. back: most |gap(t) - target| in eps S (design
promise 3), eps = 2^-52; /C+R: in eps (distance of the centres + radii). wrong: hit said for a miss or a miss for a hit.
late: a hit said at t > t*. undec: neither said. cons: hit with t_upper infinite. brckt: most t_upper - t in the last place
of t. brokn: answers that break a promise. FCL is asked every 20th case without a target gap; no answer counts as a miss.
)";

} // namespace

std::string stability_table(const Scores& scores)
{
    std::set<std::pair<std::size_t, std::size_t>> rows;
    for (const auto& [spot, unused] : scores.at)
        rows.emplace(spot.pair, spot.kind);
    std::string text;
    std::size_t last = ~std::size_t{0};
    for (const auto& [pair, kind] : rows) {
        const bool centres = pair == 0; // sphere-sphere
        if (pair != last) text += heading(support::all_pairs()[pair], centres);
        last = pair;
        add_row(text, scores, pair, kind, centres);
    }
    return text + std::string(legend);
}

std::string stability_csv(const Scores& scores)
{
    std::string text =
        "pair,class,level_from,level_to,method,cases,meets,hits,p50_ulp,p999_ulp,max_ulp,max_backward,"
        "max_backward_centres,wrong,late,undecided,conservative,max_bracket_ulp,broken\n";
    for (const auto& [spot, by_solver] : scores.at) {
        const support::StressClass& kind = support::stress_classes[spot.kind];
        const double level = kind.first + static_cast<double>(spot.step) * kind.decades;
        for (std::size_t i = 0; i < by_solver.size(); ++i) {
            const Score& s = by_solver[i];
            if (s.cases == 0) continue;
            text += fmt::format(
                "{},{},{:g},{:g},{},{},{},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{},{},{},{},{:.4g},{}\n",
                support::all_pairs()[spot.pair].name(), kind.name, level, level + kind.decades,
                solver_names[i], s.cases, s.meets, s.ulps.size(), s.ulp_at(0.5), s.ulp_at(most), s.ulp_at(1),
                s.backward, s.backward_centres, s.wrong, s.late, s.undecided, s.conservative, s.bracket,
                s.broken);
        }
    }
    return text;
}

} // namespace brink::bench
