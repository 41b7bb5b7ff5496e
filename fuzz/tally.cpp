// SPDX-License-Identifier: BSD-3-Clause
#include "tally.h"

#include "print.h"

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
    const std::uint64_t undecided = count(tally, Status::undecided);
    return fmt::format("{:22} {:22} {:>9} {:>8} {:>8} {:>9} {:>6} {:>6} {:>9} {:>9} {:>8} {:>8} {:>9} {:>8} "
                       "{:>7} {:>6} {:>8} "
                       "{:>8} {:>6} {:>5} {:>6}\n",
                       pair.name(), judges(pair), tally.cases, count(tally, Status::hit),
                       count(tally, Status::touching), count(tally, Status::separated), undecided,
                       undecided - std::min(undecided, tally.excused), tally.quick, tally.strict,
                       tally.unproven, tally.asked, tally.ruled, tally.in_digits, tally.sworn,
                       tally.unsettled, tally.referenced, tally.witnessed, fault_count(tally),
                       tally.crashes + tally.hangs, tally.brink_findings());
}

std::string median_and_most(std::vector<double> values)
{
    if (values.empty()) return fmt::format("{:>24}", "-");
    std::sort(values.begin(), values.end());
    return fmt::format("{:>6} {:>8.1e} {:>8.1e}", values.size(), values[values.size() / 2], values.back());
}

/// How early, and at what price.
std::string second_row(const Pair& pair, const Tally& tally)
{
    const auto share = [](std::uint64_t part, std::uint64_t whole) {
        return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
    };
    std::string out =
        fmt::format("{:22} {:>7.2f} {:>7.2f} {:>5}", pair.name(), share(tally.evaluations, tally.cases),
                    share(tally.hit_evaluations, tally.advanced_hits), tally.most_evaluations);
    for (const std::vector<double>& values : tally.early)
        out += "  " + median_and_most(values);
    return out + "\n";
}

/// Fewer than 1 in 100,000 is asked.
std::string undecided_share(const Pair& pair, const Tally& tally)
{
    const std::uint64_t undecided = count(tally, Status::undecided);
    constexpr double most = 1e-5;
    const double share = static_cast<double>(undecided) / static_cast<double>(tally.cases);
    if (share < most || undecided < 2) return {};
    return fmt::format("  {:22} FAIL: undecided {} of {} ({:.1e}, asked {:.0e})\n", pair.name(), undecided,
                       tally.cases, share, most);
}

std::string summary(const Pair& pair, const Tally& tally)
{
    std::string out;
    if (tally.given_up > 0)
        out += fmt::format("  {:22} {:>7} x the reference gave up\n", pair.name(), tally.given_up);
    if (tally.unsettled > 0)
        out += fmt::format("  {:22} {:>7} x the referee gave up\n", pair.name(), tally.unsettled);
    out += undecided_share(pair, tally);
    for (const auto& [check, number] : tally.complaints_by_check)
        out += fmt::format("  {:22} {:>7} x brink: {}{}\n", pair.name(), number, check,
                           number > Tally::most_printed ? ", the first of which follow" : "");
    return out;
}

} // namespace

void Tally::add_early(double tolerance, double steps)
{
    std::size_t i = 0;
    while (i < tolerances.size() && tolerance > tolerances[i])
        ++i;
    early[i].push_back(steps);
}

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
    quick += other.quick;
    strict += other.strict;
    unproven += other.unproven;
    asked += other.asked;
    ruled += other.ruled;
    in_digits += other.in_digits;
    unsettled += other.unsettled;
    sworn += other.sworn;
    in_doubt += other.in_doubt;
    excused += other.excused;
    referenced += other.referenced;
    given_up += other.given_up;
    witnessed += other.witnessed;
    evaluations += other.evaluations;
    advanced_hits += other.advanced_hits;
    hit_evaluations += other.hit_evaluations;
    most_evaluations = std::max(most_evaluations, other.most_evaluations);
    for (std::size_t i = 0; i < early.size(); ++i)
        early[i].insert(early[i].end(), other.early[i].begin(), other.early[i].end());
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
        if (check != guilty) sum += number;
    return sum;
}

std::string judges(const Pair& pair)
{
    if (pair.unbounded()) return "(must be invalid)";
#if BRINK_HAVE_FCL
    if (pair.second == 9 && pair.first == 5) return "referee coll";
    if (pair.second == 9 && pair.first != 4)
        return pair.first == 3 || pair.first == 8 ? "referee dist coll" : "referee dist CA coll";
    if (pair.second >= 6) return pair.first == 4 || pair.first == 5 ? "referee" : "referee dist coll";
    if (pair.second >= 4) return pair.first < 3 ? "ref coll" : "ref";
    if (pair.first == 3) return "ref ccd";
    return pair.second == 3 ? "ref dist coll ccd" : "ref dist CA coll ccd";
#else
    return "ref";
#endif
}

std::string report(const std::vector<Pair>& pairs, const std::vector<Tally>& tallies)
{
    std::string out =
        fmt::format("{:22} {:22} {:>9} {:>8} {:>8} {:>9} {:>6} {:>6} {:>9} {:>9} {:>8} {:>8} {:>9} {:>8} "
                    "{:>7} {:>6} {:>8} {:>8} {:>6} {:>5} {:>6}\n",
                    "pair", "judges", "cases", "hits", "touching", "separated", "undec.", "guilty", "doubles",
                    "strict", "doubts", "asked", "ruled", "digits", "sworn", "unset.", "referen.", "by FCL",
                    "faults", "crash", "brink");
    for (std::size_t i = 0; i < pairs.size(); ++i)
        out += row(pairs[i], tallies[i]);
    out += "guilty: undecided, and not known to graze. doubles: by the judge in doubles; strict: of those, "
           "proven "
           "to the last bit, the others but for rounding or, doubts, not. asked: of brink in other ways. "
           "ruled: by the referee; digits: where long double "
           "proved nothing. "
           "sworn: contact found in digits. unset.: the referee gave up. referen.: by the dense "
           "reference.\nfaults: of "
           "FCL and libccd, by cause below. crash: of their process, hangs included. brink: disagreements "
           "that are "
           "brink's.\n\n";
    out += fmt::format("{:22} {:>7} {:>7} {:>5}", "pair", "calls", "a hit", "most");
    for (const char* tolerance : {"0", "to 1e-12", "to 1e-9", "to 1e-6", "above"})
        out += fmt::format("  {:>24}", tolerance);
    out += "\n";
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (!pairs[i].unbounded()) out += second_row(pairs[i], tallies[i]);
    out += "calls: distance evaluations a query, a hit that was advanced, and the most of those. Then, by "
           "tolerance, hits "
           "that do not graze: how many were sworn, median and greatest of contact - t in steps.\n\n";
    for (std::size_t i = 0; i < pairs.size(); ++i)
        for (const auto& [cause, fault] : tallies[i].faults)
            out += fmt::format("  {:22} {:>7} x {} (worst {:.3g}, index {})\n", pairs[i].name(), fault.count,
                               cause, fault.worst, fault.example);
    for (std::size_t i = 0; i < pairs.size(); ++i)
        out += summary(pairs[i], tallies[i]);
    for (std::size_t i = 0; i < pairs.size(); ++i)
        for (const Complaint& c : tallies[i].complaints)
            out += fmt::format("\n// {} {}: {}: {}\n{}", pairs[i].name(), c.index, c.check, c.detail,
                               support::as_cpp(c.asked, c.note));
    return out;
}

} // namespace brink::fuzz
