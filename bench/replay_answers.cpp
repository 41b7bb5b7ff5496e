// SPDX-License-Identifier: BSD-3-Clause
#include "replay_answers.h"

#include "output.h"

#include <fcl.h>
#include <verdict.h>

#if BRINK_HAVE_REFEREE
#include <referee_turning.h>
#endif

#include <fmt/format.h>

#include <algorithm>

namespace brink::bench {
namespace {

using support::FclBody;
using support::FclQuestion;
using support::Query;

constexpr std::array questions{FclQuestion::conservative_advancement, FclQuestion::naive};

/// FCL's motions cannot turn by more than a half turn.
constexpr double widest_turn = 3.1;

/// Whether FCL has such shapes, motions and options.
bool fcl_knows(FclQuestion question, const Query& q)
{
    const Options& o = q.options;
    const bool plain = o.t_max == 1 && o.target_gap == 0 && o.start_contact == StartContact::report;
    return plain && answer(q).status != Status::invalid && q.motion_a.rotation.norm() < widest_turn &&
           q.motion_b.rotation.norm() < widest_turn && fcl_trusts(question, q.a, q.b);
}

/// Strict with ourselves: `undecided` would keep the bodies apart, but it reports no contact.
std::optional<double> brink_contact(const Query& q)
{
    const Toi toi = answer(q);
    if (toi.status == Status::hit || toi.status == Status::touching) return toi.t;
    return std::nullopt;
}

std::vector<Said> ask_brink(const std::vector<support::KeptQuery>& queries)
{
    return ask_guarded(queries.size(), [&](std::size_t i) { return brink_contact(queries[i].query); });
}

/// Its geometries are prepared before; its motions cannot be, for they remember.
std::vector<Said> ask_fcl(FclQuestion question, const std::vector<support::KeptQuery>& queries)
{
    struct Asked {
        std::size_t index;
        FclBody a, b;
    };
    std::vector<Asked> asked;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const Query& q = queries[i].query;
        if (fcl_knows(question, q)) asked.push_back({i, FclBody(q.a), FclBody(q.b)});
    }
    const std::vector<Said> said = ask_guarded(asked.size(), [&](std::size_t k) {
        const Query& q = queries[asked[k].index].query;
        return fcl_continuous(question, asked[k].a, q.motion_a, asked[k].b, q.motion_b);
    });
    std::vector<Said> out(queries.size());
    for (std::size_t k = 0; k < asked.size(); ++k)
        out[asked[k].index] = said[k];
    return out;
}

} // namespace

std::size_t ReplayAnswers::pair(std::size_t query) const
{
    static const std::vector<support::Pair> all = support::all_pairs();
    const Query& q = queries[query].query;
    const auto [low, high] = std::minmax({q.a.index(), q.b.index()});
    const auto same = [first = low, second = high](const support::Pair& p) {
        return p.first == first && p.second == second;
    };
    return static_cast<std::size_t>(std::find_if(all.begin(), all.end(), same) - all.begin());
}

#if BRINK_HAVE_REFEREE

bool has_referee() { return true; }

Fact fact_of(const Query& q)
{
    if (!support::judgeable(q) || q.options.start_contact != StartContact::report) return {};
    const support::Meeting m = support::meeting(q);
    if (m.in_doubt || m.spent) return {};
    if (m.started) return {Fact::Outcome::starts, 0};
    if (m.meets) return {Fact::Outcome::meets, static_cast<double>(m.by)};
    return {Fact::Outcome::apart, 0};
}

std::vector<std::string> objections_to(const Query& q, const Toi& toi)
{
    std::vector<std::string> out;
    if (!support::judgeable(q)) return out;
    for (const support::Finding& f : support::rule(q, toi).findings)
        out.push_back(f.check + ": " + f.detail);
    if (toi.status != Status::undecided) return out;
    const support::Meeting m = support::meeting(q);
    if (!m.spent && !support::grazes(q, m, toi.t)) out.emplace_back("undecided, though nothing grazes");
    return out;
}

#else

bool has_referee() { return false; }
Fact fact_of(const Query&) { return {}; }
std::vector<std::string> objections_to(const Query&, const Toi&) { return {}; }

#endif

ReplayAnswers ask_all(const std::string& file)
{
    ReplayAnswers out;
    out.file = file;
    out.queries = support::read_queries(std::filesystem::path(file));
    out.refereed = has_referee();
    Progress progress("replay", static_cast<int>(std::max<std::size_t>(out.queries.size(), 1) + 3));
    out.said[0] = ask_brink(out.queries);
    progress.step();
    for (std::size_t i = 0; i < questions.size(); ++i) {
        out.said[i + 1] = ask_fcl(questions[i], out.queries);
        progress.step();
    }
    for (const support::KeptQuery& kept : out.queries) {
        out.brink.push_back(answer(kept.query));
        out.facts.push_back(fact_of(kept.query));
        for (const std::string& what : objections_to(kept.query, out.brink.back()))
            out.objections.push_back(fmt::format("{}:{}: {}", file, kept.line, what));
        progress.step();
    }
    return out;
}

} // namespace brink::bench
