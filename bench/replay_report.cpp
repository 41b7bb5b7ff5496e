// SPDX-License-Identifier: BSD-3-Clause
#include "replay_report.h"

#include "output.h"
#include "single_query.h"

#include <print.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brink::bench {
namespace {

using Ending = Said::Ending;
using Outcome = Fact::Outcome;

bool meets(const Fact& fact) { return fact.outcome == Outcome::starts || fact.outcome == Outcome::meets; }

void judge(ReplayScore& score, const Said& said, const Fact& fact, std::vector<double>& errors)
{
    if (fact.outcome == Outcome::unknown) return;
    if (!meets(fact)) {
        score.false_contacts += said.contact ? 1 : 0;
        return;
    }
    ++score.true_contacts;
    if (!said.contact) {
        ++score.missed;
        return;
    }
    score.late += said.t - fact.t > replay_lateness ? 1 : 0;
    score.latest = std::max(score.latest, said.t - fact.t);
    if (fact.outcome == Outcome::meets) errors.push_back(std::abs(said.t - fact.t));
}

std::string row(std::string_view name, const ReplayScore& s, bool refereed)
{
    std::string out = fmt::format("  {:<30} {:>6}", name, thousands(s.asked));
    if (s.asked == 0) return out + "\n";
    if (refereed)
        out += fmt::format("  {:>6} {:>5} {:>7.0e} {:>6}  {:>7.0e} {:>7.0e} {:>7.0e}", thousands(s.missed),
                           thousands(s.late), s.latest, thousands(s.false_contacts), s.error_p50, s.error_p99,
                           s.error_most);
    const auto ns = [](double x) {
        return thousands(static_cast<std::int64_t>(std::lround(std::max(x, 0.0))));
    };
    out += fmt::format("  {:>8} {:>8} {:>8} {:>10}", ns(s.mean), ns(s.p50), ns(s.p99), ns(s.most));
    if (s.crashed + s.hung > 0) out += fmt::format("  ({} crashes, {} hangs)", s.crashed, s.hung);
    return out + "\n";
}

std::string head(const ReplayAnswers& answers)
{
    std::array<int, 4> facts{};
    for (const Fact& fact : answers.facts)
        ++facts[static_cast<std::size_t>(fact.outcome)];
    std::array<int, 5> statuses{};
    for (const Toi& toi : answers.brink)
        ++statuses[std::min<std::size_t>(static_cast<std::size_t>(toi.status), 4)];
    std::string out = fmt::format("\n{} queries of {}",
                                  thousands(static_cast<std::int64_t>(answers.queries.size())), answers.file);
    if (answers.refereed)
        out +=
            fmt::format("; by the referee {} touch at the start, {} meet later, {} stay apart, {} unknown",
                        thousands(facts[1]), thousands(facts[2]), thousands(facts[3]), thousands(facts[0]));
    else
        out += "; no referee in this build, so nobody is judged";
    out += "\nbrink says";
    for (std::size_t i = 0; i < statuses.size(); ++i)
        out += fmt::format("{} {} {}", i == 0 ? "" : ",", thousands(statuses[i]),
                           support::name(static_cast<Status>(i)));
    return out + fmt::format("; the referee objects to {}\n", answers.objections.size());
}

std::string heading(std::string_view title, bool refereed)
{
    std::string out = fmt::format("\n{:<32} {:>6}", title, "asked");
    if (refereed)
        out += fmt::format("  {:>6} {:>5} {:>7} {:>6}  {:>7} {:>7} {:>7}", "missed", "late", "by, max",
                           "false", "err p50", "p99", "worst");
    return out + fmt::format("  {:>8} {:>8} {:>8} {:>10}\n", "ns mean", "p50", "p99", "worst");
}

std::string pair_table(const ReplayAnswers& answers, const std::vector<ReplayGroup>& groups)
{
    std::string out = fmt::format("\n{:<22} {:>6} {:>9} {:>9} {:>9}\n", "ns mean, by pair", "asked", "brink",
                                  "FCL CA", "FCL def.");
    for (const ReplayGroup& group : groups) {
        if (!support::pair_named(group.name)) continue;
        out += fmt::format("  {:<20} {:>6}", group.name,
                           thousands(static_cast<std::int64_t>(group.queries.size())));
        for (std::size_t m = 0; m < replay_methods.size(); ++m) {
            const ReplayScore s = replay_score(answers, m, group.queries);
            out += s.asked == 0 ? fmt::format(" {:>9}", "-") : fmt::format(" {:>9.0f}", s.mean);
        }
        out += "\n";
    }
    return out;
}

} // namespace

ReplayScore replay_score(const ReplayAnswers& answers, std::size_t method,
                         const std::vector<std::size_t>& queries)
{
    ReplayScore score;
    std::vector<double> times, errors;
    for (const std::size_t i : queries) {
        const Said& said = answers.said[method][i];
        score.asked += said.ending != Ending::unasked ? 1 : 0;
        score.crashed += said.ending == Ending::crashed ? 1 : 0;
        score.hung += said.ending == Ending::hung ? 1 : 0;
        if (said.ending != Ending::answered) continue;
        times.push_back(said.ns);
        judge(score, said, answers.facts[i], errors);
    }
    if (!times.empty()) {
        score.mean = std::reduce(times.begin(), times.end()) / static_cast<double>(times.size());
        score.p50 = at_share(times, 0.5);
        score.p99 = at_share(times, 0.99);
        score.most = at_share(times, 1);
    }
    if (!errors.empty()) {
        score.error_p50 = at_share(errors, 0.5);
        score.error_p99 = at_share(errors, 0.99);
        score.error_most = at_share(errors, 1);
    }
    return score;
}

std::vector<ReplayGroup> replay_groups(const ReplayAnswers& answers)
{
    const std::vector<support::Pair> pairs = support::all_pairs();
    std::vector<ReplayGroup> groups{{"all", {}},
                                    {"common", {}},
                                    {"common, touching at the start", {}},
                                    {"common, meets", {}},
                                    {"common, apart", {}}};
    const std::size_t first = groups.size();
    for (const support::Pair& pair : pairs)
        groups.push_back({pair.name(), {}});
    for (std::size_t i = 0; i < answers.queries.size(); ++i) {
        groups[0].queries.push_back(i);
        groups[first + answers.pair(i)].queries.push_back(i);
        const auto answered = [i](const std::vector<Said>& said) {
            return said[i].ending == Ending::answered;
        };
        if (!std::all_of(answers.said.begin(), answers.said.end(), answered)) continue;
        groups[1].queries.push_back(i);
        const auto outcome = static_cast<std::size_t>(answers.facts[i].outcome);
        if (outcome > 0) groups[1 + outcome].queries.push_back(i);
    }
    std::erase_if(groups, [](const ReplayGroup& group) { return group.queries.empty(); });
    return groups;
}

std::string replay_tables(const ReplayAnswers& answers)
{
    std::string out = head(answers);
    const std::vector<ReplayGroup> groups = replay_groups(answers);
    for (const ReplayGroup& group : groups) {
        if (support::pair_named(group.name)) continue;
        out += heading(group.name, answers.refereed);
        for (std::size_t m = 0; m < replay_methods.size(); ++m)
            out += row(replay_methods[m], replay_score(answers, m, group.queries), answers.refereed);
    }
    out += fmt::format("missed, false: contacts. late: by more than {:g} of the step. err: |t - contact| of "
                       "those found after the start, in steps.\ncommon: what every method answered.\n",
                       replay_lateness);
    return out + pair_table(answers, groups);
}

std::string replay_csv(const ReplayAnswers& answers)
{
    std::string text =
        "group,method,asked,crashed,hung,true_contacts,missed,false_contacts,late,latest_steps,"
        "error_p50_steps,error_p99_steps,error_worst_steps,mean_ns,p50_ns,p99_ns,worst_ns\n";
    for (const ReplayGroup& group : replay_groups(answers))
        for (std::size_t m = 0; m < replay_methods.size(); ++m) {
            const ReplayScore s = replay_score(answers, m, group.queries);
            if (s.asked == 0) continue;
            std::string name = group.name;
            std::erase(name, ',');
            text += fmt::format("{},{},{},{},{},{},{},{},{},{:.3e},{:.3e},{:.3e},{:.3e},{:.1f},{:.0f},{:.0f},"
                                "{:.0f}\n",
                                name, replay_columns[m], s.asked, s.crashed, s.hung, s.true_contacts,
                                s.missed, s.false_contacts, s.late, s.latest, s.error_p50, s.error_p99,
                                s.error_most, s.mean, s.p50, s.p99, s.most);
        }
    return text;
}

} // namespace brink::bench
