// SPDX-License-Identifier: BSD-3-Clause
#include "tally.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <utility>

namespace brink::fuzz {
namespace {

std::uint64_t count(const Tally& tally, Status status)
{
    return tally.by_status[static_cast<std::size_t>(status)];
}

std::uint64_t fault_count(const Tally& tally)
{
    std::uint64_t sum = 0;
    for (const auto& [cause, fault] : tally.faults)
        sum += fault.count;
    return sum;
}

std::string row(const Pair& pair, const Tally& tally)
{
    return fmt::format(
        "{:20} {:22} {:>9} {:>8} {:>8} {:>9} {:>6} {:>9} {:>9} {:>8} {:>9.1e} {:>9.1e} {:>6} {:>5} {:>5}\n",
        pair.name(), judges(pair), tally.cases, count(tally, Status::hit), count(tally, Status::touching),
        count(tally, Status::separated), count(tally, Status::undecided), tally.refereed, tally.verified,
        tally.witnessed, tally.worst_over, tally.worst_under, fault_count(tally), tally.crashes + tally.hangs,
        tally.brink_findings());
}

std::string summary(const Pair& pair, const Tally& tally)
{
    std::string out;
    if (tally.given_up > 0)
        out += fmt::format("  {:20} {:>7} x the reference gave up\n", pair.name(), tally.given_up);
    for (const auto& [check, number] : tally.complaints_by_check)
        out += fmt::format("  {:20} {:>7} x brink: {}{}\n", pair.name(), number, check,
                           number > Tally::most_printed ? ", the first of which follow" : "");
    return out;
}

} // namespace

void Tally::add(const Fault& fault)
{
    FaultCount& sum = faults[fault.cause];
    ++sum.count;
    if (sum.count > 1 && fault.size <= sum.worst) return;
    sum.worst = fault.size;
    sum.example = fault.index;
}

void Tally::add(Complaint complaint)
{
    if (++complaints_by_check[complaint.check] <= most_printed) complaints.push_back(std::move(complaint));
}

void Tally::add(const Tally& other)
{
    cases += other.cases;
    for (std::size_t i = 0; i < by_status.size(); ++i)
        by_status[i] += other.by_status[i];
    refereed += other.refereed;
    verified += other.verified;
    witnessed += other.witnessed;
    worst_over = std::max(worst_over, other.worst_over);
    worst_under = std::min(worst_under, other.worst_under);
    given_up += other.given_up;
    crashes += other.crashes;
    hangs += other.hangs;
    for (const auto& [cause, fault] : other.faults) {
        FaultCount& sum = faults[cause];
        if (sum.count == 0 || fault.worst > sum.worst) sum = {sum.count, fault.worst, fault.example};
        sum.count += fault.count;
    }
    for (const auto& [check, number] : other.complaints_by_check)
        complaints_by_check[check] += number;
    for (const Complaint& complaint : other.complaints) {
        const auto same = [&](const Complaint& c) { return c.check == complaint.check; };
        const auto held = std::count_if(complaints.begin(), complaints.end(), same);
        if (static_cast<std::uint64_t>(held) < most_printed) complaints.push_back(complaint);
    }
}

std::uint64_t Tally::brink_findings() const
{
    std::uint64_t sum = 0;
    for (const auto& [check, number] : complaints_by_check)
        sum += number;
    return sum;
}

std::string judges(const Pair& pair)
{
    if (pair.unbounded()) return "(must be invalid)";
#if BRINK_HAVE_FCL
    if (pair.second >= 4) return pair.first < 3 ? "ref coll" : "ref";
    if (pair.first == 3) return "ref ccd";
    return pair.second == 3 ? "ref dist coll ccd" : "ref dist CA coll ccd";
#else
    return "ref";
#endif
}

std::string report(const std::vector<Pair>& pairs, const std::vector<Tally>& tallies)
{
    std::string out = fmt::format(
        "{:20} {:22} {:>9} {:>8} {:>8} {:>9} {:>6} {:>9} {:>9} {:>8} {:>9} {:>9} {:>6} {:>5} {:>5}\n", "pair",
        "judges", "cases", "hits", "touching", "separated", "undec.", "refereed", "verified", "by FCL",
        "over", "under", "faults", "crash", "brink");
    for (std::size_t i = 0; i < pairs.size(); ++i)
        out += row(pairs[i], tallies[i]);
    out += "verified: by the referee in 200 digits. over, under: extremes of gap - target_gap at t of a hit "
           "at tolerance <= 1e-9, by the reference. "
           "faults: of FCL and "
           "libccd, by "
           "cause below.\ncrash: of their process, hangs included. brink: disagreements that are brink's.\n";
    for (std::size_t i = 0; i < pairs.size(); ++i)
        for (const auto& [cause, fault] : tallies[i].faults)
            out += fmt::format("  {:20} {:>7} x {} (worst {:.3g}, index {})\n", pairs[i].name(), fault.count,
                               cause, fault.worst, fault.example);
    for (std::size_t i = 0; i < pairs.size(); ++i)
        out += summary(pairs[i], tallies[i]);
    for (std::size_t i = 0; i < pairs.size(); ++i)
        for (const Complaint& c : tallies[i].complaints)
            out += fmt::format("\n// {} {}: {}: {}\n{}", pairs[i].name(), c.index, c.check, c.detail, c.code);
    return out;
}

} // namespace brink::fuzz
